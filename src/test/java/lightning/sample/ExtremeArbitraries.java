package lightning.sample;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Placement;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.RandomDistribution;
import net.jqwik.api.Tuple;

/**
 * Small scenes and edits whose weights, falloffs and highlights range from the maximum of a scene to the underflow of a float; each power
 * of ten is equally likely.
 */
final class ExtremeArbitraries {
    private ExtremeArbitraries() {}

    static Arbitrary<List<Edit>> edits() {
        return edit().list().ofMinSize(1).ofMaxSize(10).withSizeDistribution(RandomDistribution.uniform());
    }

    static Arbitrary<Scene> scenes() {
        Arbitrary<List<Material>> materials = Combinators.combine(material("m0"), material("m1"), material("m2")).as(List::of);
        Arbitrary<PictureSettings> pictures = Combinators.combine(Arbitraries.integers().between(0, 2), Arbitraries.frequencyOf(
                Tuple.of(4, Arbitraries.of(SamplingSettings.DEFAULT)),
                Tuple.of(1, Arbitraries.of(new SamplingSettings(AntialiasMode.EDGES, 2),
                        new SamplingSettings(AntialiasMode.EVERY, 2)))))
                .as((depth, sampling) -> new PictureSettings(9, 7, depth, sampling));
        return Combinators.combine(lights().list().ofMinSize(1).ofMaxSize(2), pictures, materials, worlds())
                .as((seeds, picture, materials2, world) -> {
                    Scene scene =
                            new Scene(picture, new Camera(new Vec3(0, 2, 7), Vec3.ZERO, Vec3.Y, 40), world, materials2, nodes(), List.of());
                    for (LightTemplate seed : seeds) {
                        scene = new Edit.AddLight(scene.lights().size(), seed).applyIfValid(List.of(scene));
                    }
                    return scene;
                });
    }

    private static List<SceneNode> nodes() {
        return List.of(new Shape(Solid.PLANE, "floor", "m0", new Placement(new Vec3(0, -1, 0), Vec3.ZERO, new Vec3(9, 1, 9))),
                new Shape(Solid.SPHERE, "ball", "m1", Placement.IDENTITY));
    }

    /** Mostly dark, so that the world hides no error. */
    private static Arbitrary<World> worlds() {
        return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(new World(0, Rgb.BLACK))), Tuple.of(1, SceneArbitraries.worlds()));
    }

    private static Arbitrary<Double> powersOrSpecial(double min, double max, Double... special) {
        return Arbitraries.frequencyOf(Tuple.of(2, Arbitraries.of(special)), Tuple.of(5, NumberArbitraries.powers(min, max)));
    }

    private static Arbitrary<Double> intensities() {
        return powersOrSpecial(NumberArbitraries.MIN_EXPONENT, 30, 0.0, 1.0, 1.0, 1e22, 1e30);
    }

    private static Arbitrary<Rgb> colors() {
        Arbitrary<Double> channel = powersOrSpecial(NumberArbitraries.MIN_EXPONENT, 3, 0.0, 1.0, 1.0, 1e3);
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Rgb.WHITE)),
                Tuple.of(1, Combinators.combine(channel, channel, channel).as(Rgb::new)));
    }

    private static Arbitrary<Attenuation> attenuations() {
        Arbitrary<Double> factor = powersOrSpecial(-30, 30, 0.0, 0.0, 0.0, 1.0, 1e30);
        return Combinators.combine(factor, factor, factor).as(Attenuation::new);
    }

    private static Arbitrary<Double> exponents() {
        return powersOrSpecial(-3, 6, 0.0, 1.0, 1e6);
    }

    /** Near, or so far that the squared distance makes a falloff subnormal in float. */
    private static Arbitrary<RelativePosition> places() {
        Arbitrary<RelativePosition> near =
                NumberArbitraries.vectors(NumberArbitraries.range(-4, 4), NumberArbitraries.range(1, 6), NumberArbitraries.range(-4, 4))
                        .map(RelativePosition.Near::new);
        Arbitrary<RelativePosition> far =
                Combinators
                        .combine(
                                NumberArbitraries.vectors(NumberArbitraries.range(-1, 1), NumberArbitraries.range(0.5, 1),
                                        NumberArbitraries.range(-1, 1)),
                                NumberArbitraries.powers(1, 10))
                        .as((way, length) -> new RelativePosition.Near(way.times(length)));
        return Arbitraries.frequencyOf(Tuple.of(3, near), Tuple.of(1, far));
    }

    private static Arbitrary<LightTemplate> lights() {
        return Combinators
                .combine(LightArbitraries.types(), colors(), intensities(), attenuations(), LightArbitraries.angles(), exponents(),
                        places(), LightArbitraries.aimPositions())
                .as((type, color, intensity, attenuation, angle, dropoff, at, aim) -> new LightTemplate(Light.of("l", type).withColor(color)
                        .withIntensity(intensity).withAttenuation(attenuation).withAngle(angle).withDropoff(dropoff), at, aim));
    }

    private static Arbitrary<Material> material(String name) {
        Arbitrary<Material> plain = Arbitraries.frequencyOf(Tuple.of(2, phong(name)), Tuple.of(1, metallic(name)));
        Arbitrary<Material> clear =
                Combinators.combine(plain, NumberArbitraries.colors(), powersOrSpecial(-16, 0.5, 0.5).map(v -> 1 + Math.min(v, 3)))
                        .as((material, through, ior) -> material.withTransmission(material.transmission().withColor(through).withIor(ior)));
        return Combinators.combine(Arbitraries.frequencyOf(Tuple.of(3, plain), Tuple.of(1, clear)),
                AttributeArbitraries.extremeMaterialChanges().list().ofMaxSize(2)).as(ExtremeArbitraries::applyChanges);
    }

    private static Material applyChanges(Material material, List<MaterialChange> changes) {
        Material changed = material;
        for (MaterialChange change : changes) {
            changed = change.on(changed);
        }
        return changed;
    }

    private static Arbitrary<Material> metallic(String name) {
        return Combinators.combine(NumberArbitraries.colors(), MaterialArbitraries.unitValues(), roughness(), NumberArbitraries.colors())
                .as((base, metalness,
                        roughness, reflective) -> Material.of(name).withModel(ShadingModel.METALLIC).withAmbient(Rgb.gray(0.1))
                                .withBase(base)
                                .withMetalness(metalness).withRoughness(roughness).withReflective(reflective));
    }

    /** Over all magnitudes, most of them below the effective minimum. */
    private static Arbitrary<Double> roughness() {
        return powersOrSpecial(-3, 0, 0.0, 0.045, 1.0);
    }

    private static Arbitrary<Material> phong(String name) {
        return Combinators.combine(NumberArbitraries.colors(), NumberArbitraries.colors(), exponents(), NumberArbitraries.colors())
                .as((diffuse, specular, shininess,
                        reflective) -> Material.of(name).withAmbient(Rgb.gray(0.1)).withDiffuse(diffuse).withSpecular(specular)
                                .withShininess(shininess).withReflective(reflective));
    }

    private static Arbitrary<Edit> edit() {
        return Arbitraries.frequencyOf(Tuple.of(8, single()),
                Tuple.of(1, single().list().ofMinSize(2).ofMaxSize(3).map(Edit.CompositeEdit::new)));
    }

    private static Arbitrary<Edit> single() {
        return Arbitraries.frequencyOf(
                Tuple.of(12, Combinators.combine(Arbitraries.integers().between(0, 1), changes()).as(Edit.EditLight::new)),
                Tuple.of(2, Combinators.combine(Arbitraries.integers().between(0, 1), exponents().map(MaterialChange.Shininess::new))
                        .as(Edit.EditMaterial::new)),
                Tuple.of(2, Combinators.combine(Arbitraries.integers().between(0, 1), Arbitraries.oneOf(
                        roughness().map(MaterialChange.Roughness::new), Arbitraries.of(ShadingModel.class).map(MaterialChange.Model::new)))
                        .as(Edit.EditMaterial::new)),
                Tuple.of(6, Combinators.combine(Arbitraries.integers().between(0, 1), AttributeArbitraries.extremeLightChanges())
                        .as(Edit.EditLight::new)),
                Tuple.of(6, Combinators.combine(Arbitraries.integers().between(0, 1), AttributeArbitraries.extremeMaterialChanges())
                        .as(Edit.EditMaterial::new)),
                Tuple.of(2, EditArbitraries.edits()),
                Tuple.of(2, Arbitraries.integers().between(1, 4).map(Edit.Undo::new)));
    }

    private static Arbitrary<LightChange> changes() {
        return Arbitraries.frequencyOf(
                Tuple.of(3, colors().map(LightChange.Color::new)),
                Tuple.of(6, intensities().map(LightChange.Intensity::new)),
                Tuple.of(4, attenuations().map(LightChange.SetAttenuation::new)),
                Tuple.of(3, exponents().map(LightChange.Dropoff::new)),
                Tuple.of(2, LightArbitraries.angles().map(LightChange.Angle::new)),
                Tuple.of(1, LightArbitraries.types().map(LightChange.Type::new)),
                Tuple.of(1, places().map(LightChange.Move::new)),
                Tuple.of(1, Arbitraries.of(new LightChange.ToggleOn())));
    }
}
