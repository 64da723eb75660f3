"""The files of SPEC section 7, read to the last bit, and what can be wrong with them."""
