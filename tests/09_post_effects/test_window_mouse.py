"""The mouse in chapter 09's window: the radial blur's centre is where it is. Under Xvfb."""
from window_case import StartedTest
from window_session import BUILD

WIDTH, HEIGHT = 320, 400


class Mouse(StartedTest):
    def test_radial_blur_follows_the_mouse(self):
        session = self.start(BUILD / "chapters" / "09_post_effects", "--validate", "on", "--size", f"{WIDTH}x{HEIGHT}",
                             "--source", "chart", "--post.radial_blur", "on", "--post.blur_by", "0.8", "--post.blur_taps", "16")
        session.park()
        aside = session.settled(0, 0, WIDTH, HEIGHT)

        def with_mouse_at(x: int, y: int) -> bytes:
            session.move(x, y)
            session.settled(0, 0, WIDTH, HEIGHT)
            session.park()  # the pointer is part of the screen
            return session.settled(0, 0, WIDTH, HEIGHT)

        left, right = with_mouse_at(40, 200), with_mouse_at(280, 200)
        self.assertTrue(left != aside, "the picture does not follow the mouse")
        self.assertTrue(left != right, "it is the same wherever the mouse is")
        self.assertTrue(with_mouse_at(40, 200) == left, "the same place gives another picture")
        self.end(session)
