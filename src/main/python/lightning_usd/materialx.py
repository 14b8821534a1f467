"""MaterialX surfaces as UsdPreviewSurface: which input becomes which, and nodes that pass an image on."""

from __future__ import annotations

from typing import Any

from output import Output

WHITE = [1.0] * 3
STANDARD = {
    "diffuseColor": ("base_color", [0.8] * 3), "weight": ("base", 1.0), "metallic": ("metalness", 0.0),
    "roughness": ("specular_roughness", 0.2), "ior": ("specular_IOR", 1.5), "emissiveColor": ("emission_color", WHITE),
    "emission": ("emission", 0.0), "transmission": ("transmission", 0.0), "transmissionColor": ("transmission_color", WHITE),
    "subsurface": ("subsurface", 0.0), "subsurfaceColor": ("subsurface_color", WHITE), "clearcoat": ("coat", 0.0),
    "clearcoatRoughness": ("coat_roughness", 0.1), "clearcoatIor": ("coat_IOR", 1.5), "specular": ("specular", 1.0),
    "specularTint": ("specular_color", WHITE),
    "opacity": ("opacity", WHITE), "normal": ("normal", None), "coatNormal": ("coat_normal", None), "sheen": ("sheen", 0.0), "sheenColor": ("sheen_color", WHITE),
    "sheenRoughness": ("sheen_roughness", 0.3), "anisotropy": ("specular_anisotropy", 0.0), "anisotropyRotation": ("specular_rotation", 0.0),
}
OPEN_PBR = {
    "diffuseColor": ("base_color", [0.8] * 3), "weight": ("base_weight", 1.0), "metallic": ("base_metalness", 0.0),
    "roughness": ("specular_roughness", 0.3), "ior": ("specular_ior", 1.5), "emissiveColor": ("emission_color", WHITE),
    "emission": ("emission_luminance", 0.0), "transmission": ("transmission_weight", 0.0),
    "transmissionColor": ("transmission_color", WHITE), "subsurface": ("subsurface_weight", 0.0),
    "subsurfaceColor": ("subsurface_color", [0.8] * 3), "clearcoat": ("coat_weight", 0.0),
    "clearcoatRoughness": ("coat_roughness", 0.0), "clearcoatIor": ("coat_ior", 1.6), "specular": ("specular_weight", 1.0),
    "specularTint": ("specular_color", WHITE), "opacity": ("geometry_opacity", 1.0),
    "normal": ("geometry_normal", None), "coatNormal": ("geometry_coat_normal", None), "sheen": ("fuzz_weight", 0.0), "sheenColor": ("fuzz_color", WHITE),
    "sheenRoughness": ("fuzz_roughness", 0.5), "anisotropy": ("specular_roughness_anisotropy", 0.0),
}
GLTF_PBR = {
    "diffuseColor": ("base_color", WHITE), "metallic": ("metallic", 1.0), "roughness": ("roughness", 1.0), "ior": ("ior", 1.5),
    "emissiveColor": ("emissive", [0.0] * 3), "emission": ("emissive_strength", 1.0), "transmission": ("transmission", 0.0),
    "clearcoat": ("clearcoat", 0.0), "clearcoatRoughness": ("clearcoat_roughness", 0.0),
    "specular": ("specular", 1.0), "specularTint": ("specular_color", WHITE), "opacity": ("alpha", 1.0), "alphaMode": ("alpha_mode", 0.0),
    "opacityThreshold": ("alpha_cutoff", 0.5), "normal": ("normal", None), "coatNormal": ("clearcoat_normal", None), "sheenColor": ("sheen_color", [0.0] * 3), "sheenRoughness": ("sheen_roughness", 0.0),
    "anisotropy": ("anisotropy_strength", 0.0), "anisotropyRotation": ("anisotropy_rotation", 0.0),
}
SURFACES = {"ND_standard_surface_surfaceshader": STANDARD, "ND_open_pbr_surface_surfaceshader": OPEN_PBR,
            "ND_gltf_pbr_surfaceshader": GLTF_PBR}
# What no material of a scene has: its inputs, and the value without effect.
MISSING = {"anisotropy of coats": (("coat_anisotropy", "coat_roughness_anisotropy"), 0.0),
           "directions of anisotropy (geometry_tangent)": (("geometry_tangent", "tangent"), None),
           "thin films": (("thin_film_thickness", "thin_film_weight", "iridescence"), 0.0),
           "diffuse roughness": (("diffuse_roughness", "base_diffuse_roughness"), 0.0), "colors of coats": (("coat_color",), 1.0)}
# Inputs of these that another one switches on.
WEIGHTS = {"coat_anisotropy": ("coat",), "coat_roughness_anisotropy": ("coat_weight",),
           "geometry_tangent": ("specular_roughness_anisotropy",), "tangent": ("specular_anisotropy", "anisotropy_strength"), "coat_color": ("coat", "coat_weight"), "thin_film_thickness": ("thin_film_weight",)}
# Nodes of the surface's own directions.
DIRECTIONS = ("ND_normal_", "ND_tangent_", "ND_bitangent_", "ND_geompropvalue_")
# Inputs whose textures are shown, or become their mean.
TEXTURED = {"diffuseColor", "metallic", "roughness", "emissiveColor", "opacity", "normal", "coatNormal", "clearcoat", "clearcoatRoughness", "specular",
            "specularTint", "sheenColor", "sheenRoughness"}
# Inputs whose textures the importer notes, as those of a UsdPreviewSurface.
COUNTED = {"ior"}
# Inputs whose textures are numbers, not colors.
NUMBERS = {"metallic", "roughness", "opacity", "clearcoat", "clearcoatRoughness", "specular", "sheenRoughness"}
IMAGES = ("ND_image_", "ND_tiledimage_", "ND_UsdUVTexture", "ND_gltf_image_", "ND_gltf_colorimage", "ND_gltf_normalmap")
CHANNELS = {"outr": "r", "outg": "g", "outb": "b", "outx": "r", "outy": "g", "outz": "b", "outa": "a", "outw": "a"}
MASK, BLEND = 1, 2


def is_preview_image(kind: str) -> bool:
    """Returns whether a shader reads an image file with a scale and a bias of its colors."""
    return kind.removeprefix("ND_").startswith("UsdUVTexture")


def is_image(kind: str) -> bool:
    """Returns whether a shader reads an image file."""
    return kind == "UsdUVTexture" or kind.startswith(IMAGES)


def as_preview(result: dict[str, Any], out: Output) -> dict[str, Any]:
    """Combines the inputs of a MaterialX surface as those of a UsdPreviewSurface."""
    textures = result["textures"]
    weigh(result, "diffuseColor", result.pop("weight", 1.0))
    weigh(result, "emissiveColor", result.pop("emission"))
    weigh(result, "specularTint", result.pop("specular"))
    weigh(result, "sheenColor", result.pop("sheen", 1.0))
    result.setdefault("clearcoatIor", 1.5)
    if isinstance(result["opacity"], list):
        result["opacity"] = sum(result["opacity"]) / 3
    subsurface, scattered = result.pop("subsurface", 0.0), result.pop("subsurfaceColor", None)
    if subsurface > 0 and scattered and "diffuseColor" not in textures:
        out.note("subsurface scattering, imported as diffuse")
        result["diffuseColor"] = [a + (b - a) * subsurface for a, b in zip(result["diffuseColor"], scattered)]
    transmitted = result.pop("transmissionColor", None)
    if result["transmission"] > 0 and transmitted:
        weigh(result, "diffuseColor", 1 - result["transmission"])
        result["diffuseColor"] = [a + b * result["transmission"] for a, b in zip(result["diffuseColor"], transmitted)]
    mode = result.pop("alphaMode", BLEND)
    if mode != MASK:
        result["opacityThreshold"] = 0.0
    if mode not in (MASK, BLEND):
        result["opacity"] = 1.0
        textures.pop("opacity", None)
    for name in sorted(textures.keys() - TEXTURED - COUNTED):
        out.note(f"{name} textures of MaterialX surfaces")
    return result


def weigh(result: dict[str, Any], name: str, weight: float) -> None:
    """Multiplies a color and the scale of its texture."""
    result[name] = [v * weight for v in result[name]]
    texture = result["textures"].get(name)
    if texture and weight == 0:
        del result["textures"][name]
    elif texture:
        multiply(texture, [weight] * 3)


def multiply(texture: dict[str, Any], factors: list[float]) -> None:
    """Multiplies the scale of a texture; a single factor counts for all channels, three for the colors."""
    before = texture.get("scale", [1.0] * 4)
    factors = factors * 4 if len(factors) == 1 else [*factors, 1.0][:4]
    texture["scale"] = [a * b for a, b in zip(before, factors)]
