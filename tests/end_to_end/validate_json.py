# SPDX-License-Identifier: GPL-3.0-or-later
"""validate_json.py SCHEMA FILE...: each file against a JSON Schema; 77 where the validator is missing."""
import json
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)

with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
wrong = 0
for name in sys.argv[2:]:
    with open(name, encoding="utf-8") as file:
        for error in validator.iter_errors(json.load(file)):
            print(f"{name}: {error.json_path}: {error.message[:200]}")
            wrong += 1
sys.exit(1 if wrong else 0)
