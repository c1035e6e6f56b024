// SPDX-License-Identifier: GPL-3.0-or-later
import { WebGLRenderer } from "three";
window.latticast?.attach_viewer?.(WebGLRenderer);
