"""The pose of a tool by its joints, and its wrench by what acts on them."""

from keyphase.errors import RecipeError
from keyphase.notices import Caution
from keyphase.readers.kinematics import ToolKinematics, tool_kinematics
from keyphase.readers.orientation import from_matrices
from keyphase.readers.recipes.channels import JOINT_TORQUES, Channels, Noted
from keyphase.readers.recipes.recipe import Recipe


def by_joints(channels: Channels, recipe: Recipe) -> Noted:
    """Position and orientation where none was recorded, force and torque where joints felt them.

    Raises RecipeError where the robot of the recipe cannot be used or has other joints,
    MissingPackageError where Pinocchio is not installed.
    """
    if recipe.robot is None:
        return channels, ()
    robot = tool_kinematics(recipe.robot.urdf, recipe.robot.tool_frame, f"{recipe.name}: [robot]")
    joints = channels["joints_rad"]
    _refuse_other_joints(robot, joints.shape[1], recipe, "joints")
    channels, notices = dict(channels), ()
    if "position_m" not in channels:
        channels["position_m"], turns = robot.poses(joints)
        channels["orientation_wxyz"] = from_matrices(turns, lambda row: f"row {row}")
        notices += (
            f"The pose is that of {recipe.robot.tool_frame} by the joints {robot.joints[0]} to "
            f"{robot.joints[-1]} of {recipe.robot.urdf.name}.",
        )
    torques = channels.pop(JOINT_TORQUES, None)
    if torques is not None and recipe.joint_torques is not None:
        _refuse_other_joints(robot, torques.shape[1], recipe, "joint_torques")
        signed = recipe.joint_torques.sign * torques
        channels["force_N"], channels["torque_Nm"] = robot.wrenches(joints, signed)
        told = (
            "Force and torque are estimated of joint torques, not measured: friction and errors of "
            "the robot's model are in them, so that small steps mean little."
        )
        notices += (Caution(told),)
    return channels, notices


def _refuse_other_joints(robot: ToolKinematics, count: int, recipe: Recipe, section: str) -> None:
    if count != len(robot.joints):
        raise RecipeError(
            f"{recipe.name}: [{section}]: expected a column for each of the {len(robot.joints)} "
            f"joints that move the tool ({', '.join(robot.joints)}), but there are {count}; name "
            "them in that order."
        )
