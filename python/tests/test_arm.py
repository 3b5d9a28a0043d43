"""The arm: forward kinematics and Jacobians against a chain of matrices written here with numpy."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import artcal
from support import EXAMPLES


def chain(a, d, theta, alpha, tip, q):
    """Standard Denavit-Hartenberg: Rz(theta + q) Tz(d) Tx(a) Rx(alpha), link after link."""
    transform = np.eye(4)
    for i in range(len(a)):
        ct, st, ca, sa = np.cos(theta[i] + q[i]), np.sin(theta[i] + q[i]), np.cos(alpha[i]), np.sin(alpha[i])
        transform = transform @ np.array(
            [
                [ct, -st * ca, st * sa, a[i] * ct],
                [st, ct * ca, -ct * sa, a[i] * st],
                [0, sa, ca, d[i]],
                [0, 0, 0, 1],
            ]
        )
    return (transform @ np.append(tip, 1.0))[:3]


class ArmTest(unittest.TestCase):
    def setUp(self):
        random = np.random.default_rng(7)
        self.dh = dict(
            a=random.normal(0, 100, 6),
            d=random.normal(0, 300, 6),
            theta=random.normal(0, 0.1, 6),
            alpha=random.normal(0, 1, 6),
            tip=np.array([3.0, -2.0, 150.0]),
        )
        self.q = random.uniform(-3, 3, (50, 6))
        self.arm = artcal.Arm.from_dh(**self.dh)

    def test_the_tip_is_where_the_chain_of_matrices_puts_it(self):
        expected = np.array([chain(**self.dh, q=q) for q in self.q])
        np.testing.assert_allclose(self.arm.tip(self.q), expected, atol=1e-9)
        np.testing.assert_array_equal(self.arm.tip(self.q[3]), self.arm.tip(self.q)[3:4])

    def test_layouts_other_than_rows_give_the_same(self):
        np.testing.assert_array_equal(self.arm.tip(np.asfortranarray(self.q)), self.arm.tip(self.q))
        np.testing.assert_array_equal(self.arm.tip(np.repeat(self.q, 2, axis=0)[::2]), self.arm.tip(self.q))

    def test_the_jacobian_is_the_difference_quotient_of_the_chain(self):
        jacobian = self.arm.jacobian(self.q)
        self.assertEqual(jacobian.shape, (50, 3, len(self.arm.parameters)))
        h = 1e-6
        for name in ("a3", "d2", "theta4", "alpha5"):
            kind, joint = name.rstrip("0123456789"), int(name[-1]) - 1
            up, down = ({k: v.copy() for k, v in self.dh.items()} for _ in range(2))
            up[kind][joint] += h
            down[kind][joint] -= h
            quotient = np.array([(chain(**up, q=q) - chain(**down, q=q)) / (2 * h) for q in self.q])
            column = jacobian[:, :, self.arm.parameters.index(name)]
            np.testing.assert_allclose(column, quotient, atol=1e-5)
            np.testing.assert_array_equal(self.arm.jacobian(self.q, [name])[:, :, 0], column)

    def test_the_joint_jacobian_too(self):
        jacobian = self.arm.joint_jacobian(self.q)
        self.assertEqual(jacobian.shape, (50, 3, 6))
        h = 1e-6
        step = np.eye(6)[2] * h
        quotient = np.array(
            [(chain(**self.dh, q=q + step) - chain(**self.dh, q=q - step)) / (2 * h) for q in self.q]
        )
        np.testing.assert_allclose(jacobian[:, :, 2], quotient, atol=1e-5)

    def test_results_outlive_the_arm(self):
        jacobian = artcal.Arm.from_dh(**self.dh).jacobian(self.q)
        np.testing.assert_array_equal(jacobian, self.arm.jacobian(self.q))

    def test_a_file_gives_the_same_bits_back(self):
        import tempfile
        from pathlib import Path

        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "arm.toml"
            path.write_text(self.arm.to_toml())
            again = artcal.Arm.from_file(str(path))
        np.testing.assert_array_equal(again.values, self.arm.values)
        np.testing.assert_array_equal(again.tip(self.q), self.arm.tip(self.q))

    def test_values_change_by_name(self):
        moved = self.arm.with_values({"a1": 5.0})
        self.assertEqual(moved.values[moved.parameters.index("a1")], 5.0)
        self.assertEqual(moved.units[moved.parameters.index("theta1")], "rad")

    def test_errors_have_sentence_file_line_and_code(self):
        with self.assertRaises(artcal.BadInputError) as caught:
            artcal.Arm.from_file("gone.toml")
        self.assertEqual((caught.exception.file, caught.exception.line, caught.exception.code), ("gone.toml", None, 3))
        self.assertIn("there is no such file", caught.exception.message)
        with self.assertRaises(artcal.UsageError) as caught:
            self.arm.tip(self.q[:, :5])
        self.assertEqual(caught.exception.code, 2)
        self.assertIn("shape (postures, 6)", str(caught.exception))
        with self.assertRaises(artcal.UsageError):
            self.arm.jacobian(self.q, ["a9"])
        with self.assertRaises(ValueError):
            self.arm.with_values({"nothing": 1.0})

    def test_nominal_files_carry_no_covariance(self):
        arm = artcal.Arm.from_file(str(EXAMPLES / "ball-bar" / "arm.toml"))
        self.assertFalse(arm.is_identified)
        self.assertEqual(arm.joint_count, 6)
        self.assertEqual(arm.probes, ["ball 6 mm"])

    def test_to_and_from_urdf(self):
        arm = artcal.Arm.from_file(str(EXAMPLES / "two-socket-bar" / "arm.toml"))
        with tempfile.TemporaryDirectory() as folder:
            urdf = Path(folder) / "panda.urdf"
            artcal.export_urdf(arm, urdf)
            self.assertIn("<robot", urdf.read_text())
            back = artcal.import_arm(urdf)
            with self.assertRaises(artcal.BadInputError):
                artcal.import_arm(urdf, tip="no such link")
        q = np.random.default_rng(1).uniform(-2.5, 2.5, (50, 7))
        np.testing.assert_allclose(back.tip(q), arm.tip(q), atol=1e-9)


if __name__ == "__main__":
    unittest.main()
