"""Of the interpreter that has artcal._native built in (interpreter.cpp): the package finds it under its own name."""

import sys

import _native

sys.modules["artcal._native"] = _native
