package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.scene.FogAttributes;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;
import lightning.scene.value.Fog;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** Random fog and edits of it. */
final class FogArbitraries {
    private FogArbitraries() {}

    /** Returns fog of any kind, most of it thin enough to see through. */
    static Arbitrary<Fog> fogs() {
        return Combinators
                .combine(densities(), NumberArbitraries.colors().map(FogArbitraries::limited), ambients(), anisotropies(), heights(),
                        falloffs(), centers(), sizes())
                .as(Fog::new);
    }

    /** Returns scenes in fog with materials that mirror, and some that are clear. */
    static Arbitrary<Scene> scenes() {
        Arbitrary<Integer> kinds = Arbitraries.integers().between(0, 3).withoutEdgeCases();
        return Combinators.combine(SceneArbitraries.scenes(), fogs(), kinds.list().ofSize(3), Arbitraries.of(1, 2, 3, 5))
                .as((scene, fog, bounces, depth) -> bouncing(scene.withWorld(scene.world().withFog(fog))
                        .withPicture(scene.picture().withDepth(depth)), bounces))
                .map(TestBudget::limit);
    }

    /** Returns the scene with materials that bounce light; as it is if its lights are too bright for their highlights. */
    private static Scene bouncing(Scene scene, List<Integer> kinds) {
        try {
            return scene.withMaterials(bouncing(scene.materials(), kinds));
        } catch (RefusalException e) {
            return scene;
        }
    }

    /** @param kinds for each material: mirror, glass, thin glass, or as it is */
    private static List<Material> bouncing(List<Material> materials, List<Integer> kinds) {
        List<Material> result = new ArrayList<>();
        for (Material material : materials) {
            result.add(switch (kinds.get(result.size() % kinds.size())) {
                case 0 -> material.withReflective(Rgb.gray(0.7)).withTransmission(Transmission.NONE);
                case 1 -> material.withTransmission(glass(false));
                case 2 -> material.withTransmission(glass(true));
                default -> material;
            });
        }
        return result;
    }

    private static Transmission glass(boolean thin) {
        return new Transmission(new Rgb(0.9, 0.95, 1), 1.4, thin, Rgb.WHITE, 1, ShadowCasting.FULL);
    }

    private static Rgb limited(Rgb color) {
        return new Rgb(Math.min(color.r(), 1), Math.min(color.g(), 1), Math.min(color.b(), 1));
    }

    private static Arbitrary<Double> densities() {
        return Arbitraries.frequencyOf(Tuple.of(5, NumberArbitraries.range(0.01, 0.3)),
                Tuple.of(2, Arbitraries.of(1e-300, 1e-9, 5.0, 1e3, 1e9)));
    }

    private static Arbitrary<Rgb> ambients() {
        return Arbitraries.frequencyOf(Tuple.of(2, Arbitraries.of(Rgb.BLACK)),
                Tuple.of(1, Arbitraries.of(new Rgb(0.2, 0.3, 0.4), Rgb.gray(1e6))));
    }

    private static Arbitrary<Double> anisotropies() {
        return Arbitraries.of(0.0, 0.0, 0.3, -0.5, 0.9, -0.9);
    }

    private static Arbitrary<Double> heights() {
        return Arbitraries.of(0.0, 0.5, -2.0, 1e12);
    }

    private static Arbitrary<Double> falloffs() {
        return Arbitraries.of(0.0, 0.0, 0.5, 3.0, 1e-9, 1e9);
    }

    private static Arbitrary<Vec3> centers() {
        return Arbitraries.of(Vec3.ZERO, new Vec3(0.3, 0.5, -0.4), new Vec3(0, 1e9, 0));
    }

    private static Arbitrary<Vec3> sizes() {
        return Arbitraries.of(Vec3.ZERO, Vec3.ZERO, new Vec3(2, 1.5, 3), new Vec3(30, 40, 50), new Vec3(1e-9, 1, 1e12));
    }

    /** Returns edits of fog, if there is any, and some that add or remove it. */
    static Arbitrary<Edit> edits() {
        return Arbitraries.oneOf(List.of(
                densities().map(v -> new Edit.EditWorld<>(FogAttributes.DENSITY, v)),
                Arbitraries.of(new Edit.EditWorld<>(FogAttributes.DENSITY, 0.0)),
                NumberArbitraries.colors().map(v -> new Edit.EditWorld<>(FogAttributes.COLOR, limited(v))),
                ambients().map(v -> new Edit.EditWorld<>(FogAttributes.AMBIENT, v)),
                anisotropies().map(v -> new Edit.EditWorld<>(FogAttributes.ANISOTROPY, v)),
                heights().map(v -> new Edit.EditWorld<>(FogAttributes.HEIGHT, v)),
                falloffs().map(v -> new Edit.EditWorld<>(FogAttributes.FALLOFF, v)),
                centers().map(v -> new Edit.EditWorld<>(FogAttributes.CENTER, v)),
                sizes().map(v -> new Edit.EditWorld<>(FogAttributes.SIZE, v))));
    }
}
