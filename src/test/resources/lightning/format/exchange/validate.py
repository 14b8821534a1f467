"""Prints what usd-core's validators find in stages: `validate.py stage.usda ...`, one line for each fault, and `checked` for each stage."""

import sys

from pxr import Usd, UsdValidation

context = UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())
for file in sys.argv[1:]:
    for error in context.Validate(Usd.Stage.Open(file)):
        print(file, error.GetName(), error.GetMessage())
    print("checked")
