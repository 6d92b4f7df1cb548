"""The command `keyphase open`: the page on recordings or folders of them."""

from dataclasses import dataclass
from pathlib import Path

import tyro


@dataclass(frozen=True)
class Open:
    """Open the page on recordings: files, or folders that are searched for them."""

    paths: tyro.conf.Positional[tuple[Path, ...]] = ()
    """Recordings or folders of recordings; without any, the page tells how to begin."""
    beside: Path | None = None
    """A folder of another person's segment files of the same recordings: every moment at which the
    two differ is visited with J."""
    host: str = "127.0.0.1"
    """Address to listen on; anything but 127.0.0.1 lets other machines knock."""
    port: int = 0
    """Port to listen on; 0 takes a free one."""
    browser: bool = True
    """Open the page in the browser."""
    read_only: bool = False
    """Give a link for looking: nothing can be changed."""
    upload_limit_mb: int = 2048
    """The largest file that can be dropped on the page [MB]."""
    recipe: Path | None = None
    """How to read tables that are not in keyphase's own form (TOML)."""
    robot: Path | None = None
    """Show another robot than the YuMi (URDF)."""
    tool_frame: str | None = None
    """The link of that robot that is the tool."""

    def run(self) -> int:
        """Serve the page until interrupted."""
        from keyphase.web import open_page

        open_page(
            self.paths,
            host=self.host,
            port=self.port,
            open_browser=self.browser,
            read_only=self.read_only,
            upload_limit_bytes=self.upload_limit_mb << 20,
            recipe=self.recipe,
            robot=self.robot,
            tool_frame=self.tool_frame,
            beside=self.beside,
        )
        return 0
