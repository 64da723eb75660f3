"""Reports for people and machines, all made from the record of a run or of a check."""
