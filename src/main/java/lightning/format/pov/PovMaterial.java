package lightning.format.pov;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import lightning.base.math.Rgb;
import lightning.scene.Clarity;
import lightning.scene.Material;
import lightning.scene.Relief;
import lightning.scene.ShadowsThrown;
import lightning.scene.Solid;
import lightning.scene.SurfaceModel;
import lightning.scene.TextureMap;

/**
 * Writes materials. POV-Ray's colour of a point is pigment·(ambient·ambient_light + Σ diffuse) + phong + reflection, so
 * kd·(1 − kr) is the pigment, and what is emitted is divided by it.
 */
final class PovMaterial {
    /** Stands for a pigment of 0 where something is emitted: far below half a step of 8 bits. */
    private static final double LEAST_PIGMENT = 1e-5;

    /** POV-Ray's amount for a height of 1. */
    private static final double BUMP = 7.5;

    private final List<String> losses;

    PovMaterial(List<String> losses) {
        this.losses = losses;
    }

    /**
     * The texture of a shape, on one or several lines.
     *
     * @param image the texture's file
     * @param mask  the file of what is there
     * @param bumps the file of heights
     */
    String text(Material material, Solid solid, String image, String mask, String bumps) {
        String text =
                text(material, solid, image).replaceFirst("\n    finish", Matcher.quoteReplacement(relief(material, solid, bumps)) + "$0");
        return material.cutout().cuts() ? cut(material, solid, text, mask) : text;
    }

    /** The same where the picture's numbers reach the cutoff, and a texture that lets all through elsewhere. */
    private String cut(Material m, Solid solid, String whole, String mask) {
        double cutoff = m.cutout().cutoff();
        String uv = solid instanceof Solid.Triangles ? "uv_mapping " : "";
        String rest = whole.substring(whole.indexOf('{') + 1);
        int end = textureEnd(rest);
        return "texture {\n    " + uv + "pigment_pattern { image_map { png \"" + mask + "\" " + mapping(solid) + " interpolate 2 } "
                + String.join(" ", placing(m, m.cutout().cutout().orElseThrow(), solid)) + " }\n    texture_map {\n      [" + cutoff
                + " pigment { rgbt 1 } finish { ambient 0 diffuse 0 }]\n      [" + cutoff + " " + rest.substring(0, end)
                + "]\n    }\n  }" + rest.substring(end + 1);
    }

    /** Where the brace stands that closes a texture whose opening one stands before the text. */
    private static int textureEnd(String text) {
        int open = 1;
        int at = 0;
        for (; open > 0; at++) {
            char c = text.charAt(at);
            open += c == '{' ? 1 : c == '}' ? -1 : 0;
        }
        return at - 1;
    }

    private String text(Material material, Solid solid, String image) {
        Material m = material.isMetallic() ? phong(material) : material;
        if (m.clarity().isClear()) {
            return clear(m) + shadows(m);
        }
        return (m.texture().isPresent() ? textured(m, m.texture().get(), solid, image) : plain(m)) + shadows(m);
    }

    /**
     * POV-Ray takes Σ 0.1·amount/accuracy·f(p + accuracy·e)·e from a normal, e being the four corners of a tetrahedron, which is
     * 0.1·amount·4/3·∇f, and without a scale of bumps of normals in the scene. Its bump_map would lean along the axes of space instead of the picture's.
     */
    private String relief(Material m, Solid solid, String bumps) {
        Relief relief = m.relief();
        if (relief.leans()) {
            lose("material " + m.name() + ": its normal map is left out, POV-Ray has none");
        }
        if (relief.bumps() && solid instanceof Solid.Triangles) {
            lose("material " + m.name() + ": its bump map is left out on meshes, on which POV-Ray knows no slopes of pictures");
        }
        if (!relief.bumps() || solid instanceof Solid.Triangles) {
            return "";
        }
        TextureMap map = relief.bump().orElseThrow();
        return "\n    normal { pigment_pattern { image_map { png \"" + bumps + "\" gamma 1.0 " + mapping(solid) + " interpolate 2 } } "
                + BUMP * relief.height() + " no_bump_scale accuracy " + step(map, solid) + " " + String.join(" ", placing(m, map, solid))
                + " }";
    }

    /** About a pixel of a picture, in the space of POV-Ray's maps: on a square, or around a body of radius 1. */
    private static double step(TextureMap map, Solid solid) {
        double around = solid instanceof Solid.Plane ? 1 : 2 * Math.PI;
        double along = solid instanceof Solid.Sphere ? Math.PI : 1;
        return Math.sqrt(around / map.image().width() * along / map.image().height());
    }

    private static String shadows(Material m) {
        return m.clarity().shadows() == ShadowsThrown.NONE ? "\n  no_shadow" : "";
    }

    /**
     * POV-Ray's colour of what is seen through a surface is pigment·filter, and of its body pigment·(1 − filter). Inside, from a fade_power of 1000
     * on, a way d leaves exp(−(1 − fade_color)·d/fade_distance).
     */
    private String clear(Material m) {
        Clarity clarity = m.clarity();
        double filter = clarity.clear().max();
        Rgb pigment = new Rgb(clarity.clear().r() / filter, clarity.clear().g() / filter, clarity.clear().b() / filter);
        if (m.texture().isPresent()) {
            lose("material " + m.name() + ": the texture of a clear material is left out");
        }
        if (clarity.throwsShadows()) {
            lose("material " + m.name() + ": light passes its shapes");
        }
        if (clarity.thin()) {
            lose("material " + m.name() + ": a thin pane mirrors nothing by its angle");
        }
        if (filter < 1 && m.clarity().clear().min() < filter) {
            lose("material " + m.name() + ": its body has the colour of what is seen through it");
        }
        if (filter < 1) {
            lose("material " + m.name() + ": its body loses nothing where its angle mirrors more");
        }
        String reflection = clarity.thin() ? m.reflective().isBlack() ? "" : " reflection { " + PovText.rgb(m.reflective()) + " }"
                : " reflection { " + PovText.rgb(m.reflective()) + ", rgb 1 fresnel on } conserve_energy";
        String phong = m.specular().isBlack() ? ""
                : " phong " + grey(m.name(), "specular", m.specular()) + " phong_size " + m.shininess();
        String fade = clarity.isTinted() ? " fade_color " + PovText.rgb(new Rgb(fade(clarity.tint().r()), fade(clarity.tint().g()),
                fade(clarity.tint().b()))) + " fade_distance " + clarity.tintDistance() + " fade_power 1001" : "";
        return "texture {\n    pigment { rgbf <" + pigment.r() + ", " + pigment.g() + ", " + pigment.b() + ", " + filter + "> }\n"
                + "    finish { ambient " + PovText.rgb(m.ambient()) + " diffuse " + grey(m.name(), "diffuse", m.diffuse()) + phong
                + reflection + " }\n  }\n  interior { ior " + (clarity.thin() ? 1 : clarity.ior()) + fade + " }";
    }

    /** The fade_color that leaves a tint after the fade_distance. */
    private static double fade(double tint) {
        return 1 + Math.log(Math.max(tint, LEAST_PIGMENT));
    }

    /**
     * The nearest that Phong's model has: a lobe of exponent (2/α² − 2)/4, which is as wide at its top (Walter and others, Microfacet
     * models for refraction, 2007, §5.2, a quarter for the angle to the mirrored direction), and as high head-on, at most 1.
     */
    private Material phong(Material m) {
        lose("material " + m.name() + ": a metallic material is shown by Phong's model");
        double alpha = m.alpha();
        double height = Math.min(1, 1 / (4 * alpha * alpha));
        double plain = (1 - m.metalness()) * m.f0();
        Rgb metal = m.base().times(m.metalness());
        Rgb f0 = new Rgb(plain + metal.r(), plain + metal.g(), plain + metal.b());
        return m.withModel(SurfaceModel.PHONG).withDiffuse(m.base().times((1 - m.metalness()) * (1 - m.f0())))
                .withSpecular(f0.times(height)).withShininess((1 / (alpha * alpha) - 1) / 2);
    }

    private String plain(Material m) {
        Rgb one = new Rgb(1 - m.reflective().r(), 1 - m.reflective().g(), 1 - m.reflective().b());
        Rgb emitted = times(m.ambient(), one);
        Rgb diffuse = times(m.diffuse(), one);
        Rgb pigment = new Rgb(pigment(diffuse.r(), emitted.r()), pigment(diffuse.g(), emitted.g()), pigment(diffuse.b(), emitted.b()));
        Rgb ambient = new Rgb(ratio(emitted.r(), pigment.r()), ratio(emitted.g(), pigment.g()), ratio(emitted.b(), pigment.b()));
        return "texture {\n    pigment { " + PovText.rgb(pigment) + " }\n    finish { ambient " + PovText.rgb(ambient)
                + " diffuse 1 " + shine(m) + " }\n  }";
    }

    private String textured(Material m, TextureMap map, Solid solid, String image) {
        double diffuse = grey(m.name(), "diffuse, with a texture,", m.diffuse());
        double kept = 1 - grey(m.name(), "reflective, for what a texture keeps,", m.reflective());
        if (!m.ambient().isBlack()) {
            lose("material " + m.name() + ": ambient is multiplied by the texture");
        }
        Rgb ambient = m.ambient().times(kept);
        return "texture {\n    pigment { " + (solid instanceof Solid.Triangles ? "uv_mapping " : "") + "image_map { png \"" + image + "\" "
                + mapping(solid) + " interpolate 2 } "
                + String.join(" ", placing(m, map, solid)) + " }\n    finish { ambient " + PovText.rgb(ambient) + " diffuse "
                + diffuse * kept + " " + shine(m) + " }\n  }";
    }

    private static String mapping(Solid solid) {
        return switch (solid) {
            case Solid.Canonical c -> switch (c.wrap()) {
                case FLAT -> "map_type 0";
                case SPHERICAL -> "map_type 1";
                case CYLINDRICAL -> "map_type 2";
            };
            case Solid.Triangles _ -> "map_type 0";
        };
    }

    /** Puts POV-Ray's map, which lies in the xy plane or winds about y, where our texture coordinates are. */
    private List<String> placing(Material m, TextureMap map, Solid solid) {
        List<String> words = new ArrayList<>();
        if (solid instanceof Solid.Triangles) {
            words.add("scale <" + 1 / map.repeatU() + ", " + 1 / map.repeatV() + ", 1>");
            return words;
        }
        if (solid instanceof Solid.Plane) {
            words.add("scale <" + 1 / map.repeatU() + ", " + 1 / map.repeatV() + ", 1>");
            words.add("rotate <90, 0, 0> translate <-0.5, 0, -0.5>");
            return words;
        }
        if (map.repeatU() != 1 || map.repeatV() != 1) {
            lose("material " + m.name() + ": a texture around a shape does not repeat");
        }
        if (hasCaps(solid)) {
            lose("material " + m.name() + ": caps have the texture of the side's edge");
        }
        words.add("scale <-1, 1, 1> rotate <0, -90, 0>");
        return words;
    }

    private static boolean hasCaps(Solid solid) {
        return switch (solid) {
            case Solid.Canonical c -> c.hasDiscs();
            case Solid.Triangles _ -> false;
        };
    }

    private String shine(Material m) {
        List<String> words = new ArrayList<>();
        if (!m.specular().isBlack()) {
            words.add("phong " + grey(m.name(), "specular", m.specular()) + " phong_size " + m.shininess());
        }
        if (!m.reflective().isBlack()) {
            words.add("reflection { " + PovText.rgb(m.reflective()) + " }");
        }
        return String.join(" ", words);
    }

    private double grey(String material, String what, Rgb c) {
        if (c.min() != c.max()) {
            lose("material " + material + ": " + what + " is grey in POV-Ray, the mean of the three channels");
        }
        return (c.r() + c.g() + c.b()) / 3;
    }

    private void lose(String loss) {
        if (!losses.contains(loss)) {
            losses.add(loss);
        }
    }

    private static double pigment(double diffuse, double emitted) {
        return diffuse > 0 || emitted == 0 ? diffuse : LEAST_PIGMENT;
    }

    private static double ratio(double emitted, double pigment) {
        return emitted == 0 ? 0 : emitted / pigment;
    }

    private static Rgb times(Rgb a, Rgb b) {
        return new Rgb(a.r() * b.r(), a.g() * b.g(), a.b() * b.b());
    }
}
