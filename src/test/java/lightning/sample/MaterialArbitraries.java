package lightning.sample;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.Clarity;
import lightning.scene.Cutout;
import lightning.scene.Material;
import lightning.scene.Relief;
import lightning.scene.ShadowsThrown;
import lightning.scene.SurfaceModel;
import lightning.scene.Texture;
import lightning.scene.TextureMap;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** Materials: matt and glossy, mirroring and black, plain and textured. */
final class MaterialArbitraries {
    private MaterialArbitraries() {}

    static Arbitrary<Material> materials(String name) {
        Arbitrary<Material> opaque = Arbitraries.frequencyOf(Tuple.of(2, phong(name)), Tuple.of(1, metallic(name)));
        return Combinators.combine(opaque, clarities(), cutouts())
                .as((material, clarity, cutout) -> material.withClarity(clarity).withCutout(cutout));
    }

    private static Arbitrary<Material> metallic(String name) {
        return Combinators.combine(ambient(), Numbers.colors(), shares(), roughness(), shares(), sometimesBlack(), textures(),
                reliefs())
                .as((ambient, base, metalness, roughness, f0, reflective, texture, relief) -> Material.of(name)
                        .withModel(SurfaceModel.METALLIC)
                        .withAmbient(ambient).withBase(base).withMetalness(metalness).withRoughness(roughness).withF0(f0)
                        .withReflective(reflective).withTexture(texture).withRelief(relief));
    }

    /** From 0 to 1, the ends among them. */
    static Arbitrary<Double> shares() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(0.0, 1.0, 0.04)), Tuple.of(1, Numbers.between(0, 1)));
    }

    /** Mostly anything, and below and about the least that acts. */
    static Arbitrary<Double> roughness() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(0.0, 1e-300, 0.045, 1.0)), Tuple.of(1, Numbers.between(0, 0.1)),
                Tuple.of(3, Numbers.between(0, 1)));
    }

    private static Arbitrary<Material> phong(String name) {
        return Combinators.combine(ambient(), Numbers.colors(), sometimesBlack(), shininess(), sometimesBlack(), textures(),
                reliefs()).as(
                        (ambient, diffuse, specular, shininess, reflective, texture, relief) -> Material.of(name).withAmbient(ambient)
                                .withDiffuse(diffuse).withSpecular(specular).withShininess(shininess).withReflective(reflective)
                                .withTexture(texture).withRelief(relief));
    }

    /** Colours, shininess and textures that come, go and change. */
    static Arbitrary<MaterialChange> changes() {
        return Arbitraries.oneOf(List.of(
                ambient().map(MaterialChange.Ambient::new),
                Numbers.colors().map(MaterialChange.Diffuse::new),
                sometimesBlack().map(MaterialChange.Specular::new),
                sometimesBlack().map(MaterialChange.Specular::new),
                shininess().map(MaterialChange.Shininess::new),
                shininess().map(MaterialChange.Shininess::new),
                Arbitraries.of(SurfaceModel.class).map(MaterialChange.Model::new),
                Numbers.colors().map(MaterialChange.Base::new),
                shares().map(MaterialChange.Metalness::new),
                roughness().map(MaterialChange.Roughness::new),
                shares().map(MaterialChange.F0::new),
                sometimesBlack().map(MaterialChange.Reflective::new),
                sometimesBlack().map(MaterialChange.Reflective::new),
                Arbitraries.of(Rgb.BLACK).map(MaterialChange.Reflective::new),
                maps().map(Optional::of).map(MaterialChange.Textured::new),
                Arbitraries.of(new MaterialChange.Textured(Optional.empty())),
                reliefs().map(MaterialChange.Relieved::new),
                reliefs().map(MaterialChange.Relieved::new),
                Arbitraries.of(new MaterialChange.Relieved(Relief.NONE)),
                clarities().map(MaterialChange.Cleared::new),
                sometimesBlack().map(MaterialChange.Clear::new),
                iors().map(MaterialChange.Ior::new),
                Arbitraries.of(true, false).map(MaterialChange.Thin::new),
                Combinators.combine(tints(), distances()).as(MaterialChange.Tint::new),
                Arbitraries.of(ShadowsThrown.class).map(MaterialChange.Shadows::new),
                cutouts().map(MaterialChange.Cut::new),
                Arbitraries.of(Cutout.NONE).map(MaterialChange.Cut::new),
                materials("any").map(MaterialChange.Everything::new)));
    }

    private static Arbitrary<Rgb> ambient() {
        return Arbitraries.frequencyOf(Tuple.of(6, Numbers.colors()),
                Tuple.of(1, Numbers.colors().map(c -> c.times(1e6))));
    }

    private static Arbitrary<Rgb> sometimesBlack() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Rgb.BLACK)), Tuple.of(2, Numbers.colors()));
    }

    private static Arbitrary<Double> shininess() {
        return Arbitraries.frequencyOf(
                Tuple.of(3, Arbitraries.integers().between(1, 60).map(Integer::doubleValue).withoutEdgeCases()),
                Tuple.of(2, Numbers.between(0, 40)),
                Tuple.of(1, Arbitraries.of(0.0, 1.0, 0.5, 1e-6, 1e4, 1e6)));
    }

    private static Arbitrary<Optional<TextureMap>> textures() {
        return Arbitraries.frequencyOf(
                Tuple.of(4, Arbitraries.of(Optional.<TextureMap>empty())),
                Tuple.of(1, maps().map(Optional::of)));
    }

    /** None as often as not, flat ones, and bumps that are taller than wide. */
    static Arbitrary<Relief> reliefs() {
        Arbitrary<Relief> any = Combinators.combine(textures(), heights(), textures(), heights()).as(Relief::new);
        Arbitrary<Relief> bumps =
                Combinators.combine(maps(), heights()).as((map, h) -> new Relief(Optional.of(map), h, Optional.empty(), 1));
        Arbitrary<Relief> normals =
                Combinators.combine(maps(), heights()).as((map, s) -> new Relief(Optional.empty(), 1, Optional.of(map), s));
        return Arbitraries.frequencyOf(Tuple.of(4, Arbitraries.of(Relief.NONE)), Tuple.of(1, any), Tuple.of(1, bumps),
                Tuple.of(1, normals));
    }

    /** Mostly none, else of any part of the surface. */
    static Arbitrary<Cutout> cutouts() {
        Arbitrary<Cutout> some = Combinators.combine(maps().map(Optional::of), Arbitraries.of(0.5, 0.3, 1.0, 0.0, 0.75)).as(Cutout::new);
        return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(Cutout.NONE)), Tuple.of(1, some));
    }

    /** Opaque as often as not. */
    static Arbitrary<Clarity> clarities() {
        Arbitrary<Clarity> clear = Combinators.combine(Numbers.colors(), iors(), Arbitraries.of(true, false, false), tints(), distances(),
                Arbitraries.of(ShadowsThrown.class)).as(Clarity::new);
        return Arbitraries.frequencyOf(Tuple.of(5, Arbitraries.of(Clarity.NONE)),
                Tuple.of(1, Arbitraries.of(Clarity.NONE.withShadows(ShadowsThrown.NONE))), Tuple.of(4, clear));
    }

    /** From that of air to the largest, those of water, glass and diamond. */
    private static Arbitrary<Double> iors() {
        return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(1.0, 1.33, 1.5, 2.42, 4.0, 1 + 0x1p-50)),
                Tuple.of(1, Numbers.between(1, 4)));
    }

    private static Arbitrary<Rgb> tints() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Rgb.WHITE, Rgb.BLACK)), Tuple.of(2, Numbers.colors()));
    }

    private static Arbitrary<Double> distances() {
        return Arbitraries.of(1.0, 0.1, 5.0, 1e-9, 1e9);
    }

    private static Arbitrary<Double> heights() {
        return Arbitraries.of(0.01, 0.1, -0.1, 1.0, 0.0, 1e6, -3.7);
    }

    private static Arbitrary<TextureMap> maps() {
        return Combinators.combine(images(), repeats(), repeats()).as((image, u, v) -> new TextureMap("sample.png", u, v, image));
    }

    private static Arbitrary<Double> repeats() {
        return Arbitraries.of(1.0, 2.0, -1.0, 3.7, 1e-6, 1e6);
    }

    static Arbitrary<Texture> images() {
        return Arbitraries.randomValue(random -> {
            int width = 1 + random.nextInt(4);
            int height = 1 + random.nextInt(4);
            float[] rgb = new float[3 * width * height];
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] = random.nextInt(5) / 4f;
            }
            return new Texture(width, height, rgb);
        });
    }
}
