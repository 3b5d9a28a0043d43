"""Long work: the interpreter's lock is released, progress is told, Ctrl-C ends it."""

import os
import signal
import threading
import time
import unittest

import artcal
from support import EXAMPLES

RECORDING = EXAMPLES / "two-socket-bar" / "recording.toml"


class InterruptionTest(unittest.TestCase):
    def test_other_threads_go_on(self):
        ticks = []
        done = threading.Event()

        def tick():
            while not done.wait(0.005):
                ticks.append(time.monotonic())

        ticker = threading.Thread(target=tick)
        ticker.start()
        artcal.monte_carlo(RECORDING, trials=200)
        done.set()
        ticker.join()
        self.assertGreater(len(ticks), 5)

    def test_progress_is_told(self):
        told = []
        artcal.monte_carlo(RECORDING, trials=300, progress=lambda *stage: told.append(stage))
        self.assertGreater(len(told), 0)
        what, done, total = told[-1]
        self.assertEqual((what, total), ("Monte Carlo trials", 300))
        self.assertLessEqual(done, 300)

    def test_ctrl_c_ends_it(self):
        start = time.monotonic()
        threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            artcal.monte_carlo(RECORDING, trials=10_000_000)
        self.assertLess(time.monotonic() - start, 60)
        self.assertEqual(artcal.monte_carlo(RECORDING, trials=20).kind, "monte-carlo")  # and the next works

    def test_a_callback_that_fails_ends_it_with_its_exception(self):
        def fail(*_):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            artcal.monte_carlo(RECORDING, trials=10_000_000, progress=fail)

    def test_two_threads_at_once(self):
        results = {}

        def work(seed):
            results[seed] = artcal.monte_carlo(RECORDING, trials=20, seed=seed).seed

        threads = [threading.Thread(target=work, args=(seed,)) for seed in (1, 2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(results, {1: 1, 2: 2})


if __name__ == "__main__":
    unittest.main()
