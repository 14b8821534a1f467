package lightning.sample;

import java.util.List;
import java.util.Optional;
import lightning.math.Rgb;
import lightning.scene.Material;
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
        return Combinators.combine(ambient(), Numbers.colors(), sometimesBlack(), shininess(), sometimesBlack(), textures())
                .as((ambient, diffuse, specular, shininess, reflective, texture) -> Material.of(name).withAmbient(ambient)
                        .withDiffuse(diffuse).withSpecular(specular).withShininess(shininess).withReflective(reflective)
                        .withTexture(texture));
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
                sometimesBlack().map(MaterialChange.Reflective::new),
                sometimesBlack().map(MaterialChange.Reflective::new),
                Arbitraries.of(Rgb.BLACK).map(MaterialChange.Reflective::new),
                maps().map(Optional::of).map(MaterialChange.Textured::new),
                Arbitraries.of(new MaterialChange.Textured(Optional.empty())),
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
