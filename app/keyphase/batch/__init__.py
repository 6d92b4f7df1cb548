"""Many recordings at once: on all cores or a cluster, and gone on with after a stop."""
