"""Checks any program against the suite: runs it, judges its maps, says where and why they differ."""
