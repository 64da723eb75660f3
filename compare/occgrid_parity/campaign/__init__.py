"""Random worlds and logs by the thousand: which does a program map in another way, and what least shows it."""
