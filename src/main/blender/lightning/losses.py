# SPDX-License-Identifier: Apache-2.0
"""Settings of a scene that Lightning lacks: a message for each that is not Blender's default."""

from . import visibility

DEFAULT_BOUNCES = 1024


def of_scene(scene) -> list[str]:
    """Returns the messages."""
    view, camera = scene.view_settings, scene.camera and scene.camera.data
    is_cycles = scene.render.engine == "CYCLES"
    settings = (
        (view.look not in ("", "None"), f"the look {view.look} of the view is not sent"),
        (view.gamma != 1, "the gamma of the view is not sent"),
        (view.use_curve_mapping, "the curves of the view are not sent"),
        (view.use_white_balance, "the white balance of the view is not sent"),
        (scene.display_settings.display_device not in ("sRGB", "None"), f"the picture is for an sRGB display, not for {scene.display_settings.display_device}"),
        (scene.render.film_transparent, "the transparent film is not sent: the background is visible"),
        (scene.render.use_motion_blur, "motion blur is not sent"),
        (camera is not None and camera.type == "PANO" and camera.dof.use_dof, "the depth of field of the panorama is not sent"),
        (camera is not None and camera.type == "PERSP" and camera.dof.use_dof and camera.dof.aperture_ratio != 1,
         "the ratio of the camera's aperture is not sent: the opening is as high as it is wide"),
    )
    messages = [text for is_there, text in settings if is_there]
    for obj in scene.objects:
        if visibility.is_portal(obj):
            messages.append(f"{obj.name}: a portal is not sent, because it has no light of its own")
        elif obj.type == "LIGHT" and is_cycles and obj.data.cycles.max_bounces != DEFAULT_BOUNCES:
            messages.append(f"{obj.name}: its largest number of bounces ({obj.data.cycles.max_bounces}) is not sent")
    return messages
