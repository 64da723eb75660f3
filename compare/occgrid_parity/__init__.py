"""The harness that holds the ports together: builds, runs and compares them."""
