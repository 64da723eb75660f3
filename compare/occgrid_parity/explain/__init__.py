"""Why a map differs: by rounding, by a symmetry, from which beam on, by which mistake."""
