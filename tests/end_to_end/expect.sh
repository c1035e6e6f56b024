# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the command-line tests: runs commands, compares status and output, counts failures.
failures=0
checks=0

# expect STATUS COMMAND...: runs it; its output is then in $out and $err.
expect() {
  local wanted=$1 status=0
  shift
  checks=$((checks + 1))
  "$@" >"$work/out" 2>"$work/err" </dev/null || status=$?
  out=$(<"$work/out") err=$(<"$work/err")
  last="$*"
  [[ $status -eq $wanted ]] || wrong "status $status instead of $wanted"
}

# says TEXT / err_says TEXT: the last command's output (error output) contains it.
says() {
  checks=$((checks + 1))
  [[ $out == *"$1"* ]] || wrong "standard output lacks: $1"
}
err_says() {
  checks=$((checks + 1))
  [[ $err == *"$1"* ]] || wrong "standard error lacks: $1"
}

holds() {
  checks=$((checks + 1))
  "$@" || wrong "does not hold: $*"
}

wrong() {
  failures=$((failures + 1))
  printf 'FAIL after: %s\n  %s\n  out: %.600s\n  err: %.600s\n' "$last" "$1" "$out" "$err" >&2
}

# skip REASON: the checks that follow in this part cannot run here; the last lines say so.
skipped=
skip() {
  skipped+="skipped: $1"$'\n'
}

finish() {
  printf '%s' "$skipped"
  echo "$checks checks, $failures failures"
  [[ $failures -eq 0 && $checks -gt 0 ]]
}
