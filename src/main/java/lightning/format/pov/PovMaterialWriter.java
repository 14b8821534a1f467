package lightning.format.pov;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import lightning.base.math.Rgb;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureWrap;
import lightning.scene.material.Bulb;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.SurfaceMaps;
import lightning.scene.material.Transmission;
import lightning.scene.node.Solid;

/**
 * Writer for materials. POV-Ray computes a point's color as pigment·(ambient·ambient_light + emission + Σ diffuse) +
 * phong + reflection, so the pigment is kd·(1 − kr), and ambient color and glow are divided by it.
 */
record PovMaterialWriter(List<String> warnings) {
    /** Replacement for a pigment of 0 on emissive surfaces: far below half a step of 8 bits. */
    private static final double MIN_PIGMENT = 1e-5;

    /** POV-Ray's bump amount for a height of 1. */
    private static final double BUMP_SCALE = 7.5;
    /** Images that this class writes, or warns of. */
    private static final List<MaterialAttribute<Optional<TextureMap>>> WRITTEN =
            List.of(MaterialAttribute.TEXTURE, MaterialAttribute.CUTOUT,
                    MaterialAttribute.BUMP, MaterialAttribute.NORMAL_MAP, MaterialAttribute.GLOW_MAP, MaterialAttribute.ROUGHNESS_MAP,
                    MaterialAttribute.METALNESS_MAP, MaterialAttribute.F0_MAP, MaterialAttribute.SPECULAR_TINT_MAP,
                    MaterialAttribute.COAT_MAP, MaterialAttribute.COAT_ROUGHNESS_MAP);

    /**
     * Returns the texture of a shape, on one or several lines.
     *
     * @param image file of the color texture
     * @param mask file of the opacity map
     * @param bumps file of the bump map
     */
    String text(Material material, Solid solid, String image, String mask, String bumps) {
        String text =
                text(material, solid, image).replaceFirst("\n    finish",
                        Matcher.quoteReplacement(normalPattern(material, solid, bumps)) + "$0");
        return material.cutout().isActive() ? withCutout(material, solid, text, mask) : text;
    }

    /** Returns a texture that is transparent where the mask is below the cutoff. */
    private String withCutout(Material m, Solid solid, String texture, String mask) {
        double cutoff = m.cutout().cutoff();
        String uv = solid instanceof Solid.TriangleMesh ? "uv_mapping " : "";
        String rest = texture.substring(texture.indexOf('{') + 1);
        int end = textureEnd(rest);
        return "texture {\n    " + uv + "pigment_pattern { image_map { png \"" + mask + "\" " + mapping(solid) + " interpolate 2 } "
                + String.join(" ", textureTransform(m, m.cutout().map().orElseThrow(), solid)) + " }\n    texture_map {\n      [" + cutoff
                + " pigment { rgbt 1 } finish { ambient 0 diffuse 0 }]\n      [" + cutoff + " " + rest.substring(0, end)
                + "]\n    }\n  }" + rest.substring(end + 1);
    }

    /** Returns the offset of the brace that closes the enclosing texture. */
    private static int textureEnd(String text) {
        int depth = 1;
        int index = 0;
        for (; depth > 0; index++) {
            char c = text.charAt(index);
            depth += c == '{' ? 1 : c == '}' ? -1 : 0;
        }
        return index - 1;
    }

    private String text(Material material, Solid solid, String image) {
        MaterialAttribute.MAPS.stream().filter(map -> !WRITTEN.contains(map) && map.get(material).isPresent())
                .forEach(map -> warn("material " + material.name() + ": its " + map.title() + " is left out"));
        Material m = withMeanGlow(material.isMetallic() ? phong(withMeanSurface(material)) : material);
        if (material.isFrosted()) {
            warn("material " + m.name() + ": what is behind it is sharp, POV-Ray does not blur it");
        }
        if (m.transmission().isTransparent()) {
            return transparent(m) + shadows(m);
        }
        return (m.texture().isPresent() ? textured(m, m.texture().get(), solid, image) : untextured(m)) + shadows(m);
    }

    /** Returns a material whose glow has the mean color of its map, if it has one. */
    private Material withMeanGlow(Material m) {
        if (m.glowMap().isEmpty()) {
            return m;
        }
        warn("material " + m.name() + ": glow map is replaced by its mean");
        Rgb mean = m.glowMap().get().image().areas().mean();
        Bulb bulb = m.bulb().withGlow(times(m.bulb().glow(), mean));
        return m.withGlow(times(m.glow(), mean)).withBulb(bulb).withGlowMap(Optional.empty());
    }

    /** Returns a material whose numbers and reflected colors have the means of their maps, if it has some. */
    private Material withMeanSurface(Material m) {
        SurfaceMaps maps = m.surfaceMaps();
        LayerMaps layers = m.layerMaps();
        boolean hasCoatMap = layers.coat().isPresent() || layers.coatRoughness().isPresent();
        if (!m.isPrincipled() || maps.roughness().isEmpty() && !maps.changeColors() && !hasCoatMap) {
            return m;
        }
        warn("material " + m.name() + ": maps of roughness, metalness, f0, specular tint and coat are replaced by their means");
        return m.withRoughness(m.meanRoughness()).withMetalness(m.meanMetalness()).withF0(m.meanF0())
                .withSpecularTint(m.meanSpecularTint()).withSurfaceMaps(SurfaceMaps.NONE).withCoat(m.meanCoat())
                .withLayerMaps(layers.withCoat(Optional.empty()).withCoatRoughness(Optional.empty()));
    }

    /**
     * Returns the bump pattern. POV-Ray subtracts Σ 0.1·amount/accuracy·f(p + accuracy·e)·e from a normal, where e are the
     * four corners of a tetrahedron; that is 0.1·amount·4/3·∇f, and without bump scaling the normal is in scene space. Its
     * bump_map would tilt along the axes of space instead of the image's.
     */
    private String normalPattern(Material m, Solid solid, String bumps) {
        BumpMapping relief = m.bumpMapping();
        if (relief.hasNormalMap()) {
            warn("material " + m.name() + ": its normal map is left out, POV-Ray does not support it");
        }
        if (relief.hasBumpMap() && solid instanceof Solid.TriangleMesh) {
            warn("material " + m.name() + ": its bump map is left out on meshes, POV-Ray does not support it");
        }
        if (!relief.hasBumpMap() || solid instanceof Solid.TriangleMesh) {
            return "";
        }
        TextureMap map = relief.bump().orElseThrow();
        return "\n    normal { pigment_pattern { image_map { png \"" + bumps + "\" gamma 1.0 " + mapping(solid) + " interpolate 2 } } "
                + BUMP_SCALE * relief.height() + " no_bump_scale accuracy " + bumpAccuracy(map, solid) + " "
                + String.join(" ", textureTransform(m, map, solid))
                + " }";
    }

    /** Returns about one pixel of an image in the space of POV-Ray's maps: on a unit square, or around a body of radius 1. */
    private static double bumpAccuracy(TextureMap map, Solid solid) {
        double width = solid instanceof Solid.Plane ? 1 : 2 * Math.PI;
        double height = solid instanceof Solid.Sphere ? Math.PI : 1;
        return Math.sqrt(width / map.image().width() * height / map.image().height());
    }

    private static String shadows(Material m) {
        return switch (m.transmission().shadows()) {
            case FULL, TINTED -> "";
            case NONE -> "\n  no_shadow";
            case ONLY -> "\n  no_image no_reflection no_radiosity";
        };
    }

    /**
     * Returns a transparent material. POV-Ray multiplies transmitted light by pigment·filter, and the surface's own color is
     * pigment·(1 − filter). In the interior, from a fade_power of 1000 on, a path of length d transmits exp(−(1 −
     * fade_color)·d/fade_distance).
     */
    private String transparent(Material m) {
        Transmission clarity = m.transmission();
        double filter = clarity.color().max();
        Rgb pigment = new Rgb(clarity.color().r() / filter, clarity.color().g() / filter, clarity.color().b() / filter);
        if (m.texture().isPresent()) {
            warn("material " + m.name() + ": the texture of a transparent material is left out");
        }
        if (clarity.castsShadows()) {
            warn("material " + m.name() + ": its shadows are transparent in POV-Ray");
        }
        if (clarity.thin()) {
            warn("material " + m.name() + ": a thin sheet has no Fresnel reflection");
        }
        if (filter < 1 && m.transmission().color().min() < filter) {
            warn("material " + m.name() + ": its surface color is the transmission color");
        }
        if (filter < 1) {
            warn("material " + m.name() + ": its surface color is not reduced by Fresnel reflection");
        }
        String reflection = clarity.thin() ? m.reflective().isBlack() ? "" : " reflection { " + PovFormat.rgb(m.reflective()) + " }"
                : " reflection { " + PovFormat.rgb(m.reflective()) + ", rgb 1 fresnel on } conserve_energy";
        String phong = m.specular().isBlack() ? ""
                : " phong " + gray(m.name(), "specular", m.specular()) + " phong_size " + m.shininess();
        String fade = clarity.isTinted() ? " fade_color " + PovFormat.rgb(new Rgb(fade(clarity.tint().r()), fade(clarity.tint().g()),
                fade(clarity.tint().b()))) + " fade_distance " + clarity.tintDistance() + " fade_power 1001" : "";
        return "texture {\n    pigment { rgbf <" + pigment.r() + ", " + pigment.g() + ", " + pigment.b() + ", " + filter + "> }\n"
                + "    finish { ambient " + PovFormat.rgb(m.ambient()) + emission(m.emission()) + " diffuse "
                + gray(m.name(), "diffuse", m.diffuse())
                + phong
                + reflection + " }\n  }\n  interior { ior " + (clarity.thin() ? 1 : clarity.ior()) + fade + " }";
    }

    /** Returns the fade_color for a tint after the fade_distance. */
    private static double fade(double tint) {
        return 1 + Math.log(Math.max(tint, MIN_PIGMENT));
    }

    /**
     * Returns the closest Phong material: a lobe of exponent (2/α² − 2)/4, which has the same width at its peak (Walter and
     * others, Microfacet models for refraction, 2007, §5.2, divided by 4 for the angle to the reflected direction) and the
     * same height at normal incidence, at most 1. A smooth principled surface or coat reflects as it does at normal incidence.
     */
    private Material phong(Material m) {
        warn("material " + m.name() + ": a " + m.model().name().toLowerCase(Locale.ROOT) + " material is approximated by Phong's model");
        if (m.reflectsRoughly()) {
            warn("material " + m.name() + ": its blurred reflections are left out");
        }
        if (m.isAnisotropic()) {
            warn("material " + m.name() + ": its anisotropy is left out");
        }
        if (m.hasSheen()) {
            warn("material " + m.name() + ": its sheen is left out");
        }
        double alpha = m.alpha();
        double height = Math.min(1, 1 / (4 * alpha * alpha));
        Rgb f0 = m.specularTint().times((1 - m.metalness()) * m.f0()).plus(m.base().times(m.metalness()));
        double coat = m.hasSmoothCoat() ? m.coat().weight() * m.coat().f0() : 0;
        Rgb mirrored = (m.isSmooth() ? f0.times(1 - coat) : m.reflective()).plus(Rgb.gray(coat));
        double entering = m.isSmooth() ? 1 : 1 - m.f0();
        return m.withModel(ShadingModel.PHONG).withDiffuse(m.base().times((1 - m.metalness()) * entering))
                .withSpecular(f0.times(height)).withShininess((1 / (alpha * alpha) - 1) / 2).withReflective(mirrored);
    }

    private String untextured(Material m) {
        Rgb unreflected = new Rgb(1 - m.reflective().r(), 1 - m.reflective().g(), 1 - m.reflective().b());
        Rgb ambient = times(m.ambient(), unreflected);
        Rgb glow = times(m.emission(), unreflected);
        Rgb own = ambient.plus(glow);
        Rgb diffuse = times(m.diffuse(), unreflected);
        Rgb pigment = new Rgb(pigment(diffuse.r(), own.r()), pigment(diffuse.g(), own.g()), pigment(diffuse.b(), own.b()));
        return "texture {\n    pigment { " + PovFormat.rgb(pigment) + " }\n    finish { ambient " + PovFormat.rgb(ratio(ambient, pigment))
                + emission(ratio(glow, pigment)) + " diffuse 1 " + highlightText(m) + " }\n  }";
    }

    private String textured(Material m, TextureMap map, Solid solid, String image) {
        double diffuse = gray(m.name(), "diffuse, with a texture,", m.diffuse());
        double unreflected = 1 - gray(m.name(), "reflective, for what a texture keeps,", m.reflective());
        if (!m.ambient().isBlack()) {
            warn("material " + m.name() + ": ambient is multiplied by the texture");
        }
        if (!m.emission().isBlack()) {
            warn("material " + m.name() + ": glow is multiplied by the texture");
        }
        Rgb ambient = m.ambient().times(unreflected);
        return "texture {\n    pigment { " + (solid instanceof Solid.TriangleMesh ? "uv_mapping " : "") + "image_map { png \"" + image
                + "\" "
                + mapping(solid) + " interpolate 2 } "
                + String.join(" ", textureTransform(m, map, solid)) + " }\n    finish { ambient " + PovFormat.rgb(ambient)
                + emission(m.emission().times(unreflected)) + " diffuse " + diffuse * unreflected + " " + highlightText(m) + " }\n  }";
    }

    private static String mapping(Solid solid) {
        return switch (solid) {
            case Solid.Canonical c -> switch (c.wrap()) {
                case FLAT -> "map_type 0";
                case SPHERICAL -> "map_type 1";
                case CYLINDRICAL -> "map_type 2";
            };
            case Solid.TriangleMesh _ -> "map_type 0";
        };
    }

    /** Maps POV-Ray's image map, in the xy plane or around y, to our texture coordinates. */
    private List<String> textureTransform(Material m, TextureMap map, Solid solid) {
        List<String> statements = new ArrayList<>();
        if (!map.wrap().equals(TextureWrap.REPEAT)) {
            warn("material " + m.name() + ": a texture repeats beyond its edges");
        }
        TexturePlacement placement = map.placement();
        boolean isFlat = solid instanceof Solid.TriangleMesh || solid instanceof Solid.Plane;
        if (!placement.isNone() && isFlat) {
            // POV-Ray moves the image, not the coordinates.
            statements
                    .add("translate <" + -placement.offsetU() + ", " + -placement.offsetV() + ", 0> rotate <0, 0, " + -placement.rotation()
                            + ">");
        }
        if (solid instanceof Solid.TriangleMesh) {
            statements.add("scale <" + 1 / map.repeatU() + ", " + 1 / map.repeatV() + ", 1>");
            return statements;
        }
        if (solid instanceof Solid.Plane) {
            statements.add("scale <" + 1 / map.repeatU() + ", " + 1 / map.repeatV() + ", 1>");
            statements.add("rotate <90, 0, 0> translate <-0.5, 0, -0.5>");
            return statements;
        }
        if (map.repeatU() != 1 || map.repeatV() != 1) {
            warn("material " + m.name() + ": a wrapped texture does not repeat");
        }
        if (!placement.isNone()) {
            warn("material " + m.name() + ": a wrapped texture is neither rotated nor moved");
        }
        if (hasCaps(solid)) {
            warn("material " + m.name() + ": caps repeat the texture's edge");
        }
        statements.add("scale <-1, 1, 1> rotate <0, -90, 0>");
        return statements;
    }

    private static boolean hasCaps(Solid solid) {
        return switch (solid) {
            case Solid.Canonical c -> c.hasCaps();
            case Solid.TriangleMesh _ -> false;
        };
    }

    private String highlightText(Material m) {
        List<String> statements = new ArrayList<>();
        if (!m.specular().isBlack()) {
            statements.add("phong " + gray(m.name(), "specular", m.specular()) + " phong_size " + m.shininess());
        }
        if (!m.reflective().isBlack()) {
            statements.add("reflection { " + PovFormat.rgb(m.reflective()) + " }");
        }
        return String.join(" ", statements);
    }

    private double gray(String material, String label, Rgb c) {
        if (c.min() != c.max()) {
            warn("material " + material + ": " + label + " is gray in POV-Ray, the mean of the three channels");
        }
        return (c.r() + c.g() + c.b()) / 3;
    }

    private void warn(String warning) {
        if (!warnings.contains(warning)) {
            warnings.add(warning);
        }
    }

    private static double pigment(double diffuse, double emission) {
        return diffuse > 0 || emission == 0 ? diffuse : MIN_PIGMENT;
    }

    /** Returns the statement for a glow: empty if there is none. */
    private static String emission(Rgb glow) {
        return glow.isBlack() ? "" : " emission " + PovFormat.rgb(glow);
    }

    private static Rgb ratio(Rgb emission, Rgb pigment) {
        return new Rgb(ratio(emission.r(), pigment.r()), ratio(emission.g(), pigment.g()), ratio(emission.b(), pigment.b()));
    }

    private static double ratio(double emission, double pigment) {
        return emission == 0 ? 0 : emission / pigment;
    }

    private static Rgb times(Rgb a, Rgb b) {
        return new Rgb(a.r() * b.r(), a.g() * b.g(), a.b() * b.b());
    }
}
