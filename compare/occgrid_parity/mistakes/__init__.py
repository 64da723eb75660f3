"""A catalogue of mistakes that programs for the lesson have, each planted in a mapper that has no other."""
