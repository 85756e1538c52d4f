"""The least that viser can do with a gizmo: one frame follows it, flushed. Run as a module; prints its address."""

from __future__ import annotations

import signal

import viser


def main() -> None:
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    frame = server.scene.add_frame("/echo")
    gizmo = server.scene.add_transform_controls("/target")

    @gizmo.on_update
    async def follow(event: viser.TransformControlsEvent) -> None:
        frame.position = event.target.position
        server.flush()

    print(f"http://127.0.0.1:{server.get_port()}", flush=True)
    signal.pause()


if __name__ == "__main__":
    main()
