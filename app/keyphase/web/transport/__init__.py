"""One port: access, sockets, responses, and the hook into viser's server."""
