"""sin, cos, exp and log as Python's math module has them: FOLDER/sin.txt to FOLDER/sin.out, and so on."""

import math
import sys
from pathlib import Path

folder = Path(sys.argv[1])
for function in (math.sin, math.cos, math.exp, math.log):
    arguments = (folder / f"{function.__name__}.txt").read_text().split()
    results = [repr(function(float(text))) + "\n" for text in arguments]
    (folder / f"{function.__name__}.out").write_text("".join(results))
