package lightning.render.relight.tile;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.engine.Engine;
import lightning.render.engine.choice.Engines;
import lightning.render.image.FilmAssert;
import lightning.render.relight.Renderer;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

/** Tests repeated edits of scenes with several clear materials. */
class RepeatedClearEditTest {
    private static final Transmission CLEAR = Transmission.NONE.withColor(Rgb.WHITE).withTint(new Rgb(0.9, 0.3, 1)).withTintDistance(0.5);

    /** Balls of four glasses, one in front of the other, before a stone. Plain glass takes no light at its surface. */
    private static Scene scene() {
        List<Material> materials = List.of(plainGlass("plain", 1.5), plainGlass("dense", 1.9),
                plainGlass("glossy", 1.4).withSpecular(Rgb.gray(0.3)).withShininess(8),
                Material.of("milky").withDiffuse(Rgb.gray(0.7)).withTransmission(CLEAR.withColor(new Rgb(0.5, 0.4, 0.3)).withIor(1.3)),
                Material.of("stone").withReflective(Rgb.gray(0.2)));
        List<Shape> shapes = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            shapes.add(new Shape(Solid.SPHERE, "ball" + i, materials.get(i % 5).name(),
                    new Placement(new Vec3(i % 4 - 1.5, i / 4 - 1, -0.7 * (i % 3)), Vec3.ZERO, Vec3.ONE.times(0.7))));
        }
        return new Scene(new PictureSettings(48, 32, 4), new Camera(new Vec3(0, 0, 8), Vec3.ZERO, Vec3.Y, 30), World.DEFAULT, materials,
                List.copyOf(shapes),
                List.of(Light.of("key", LightType.POINT).withPosition(new Vec3(3, 4, 6)).withIntensity(0.7),
                        Light.of("fill", LightType.DIRECTIONAL).withDirection(new Vec3(1, -0.1, -0.5)).withIntensity(0.3)));
    }

    private static Material plainGlass(String name, double ior) {
        return Material.of(name).withDiffuse(Rgb.BLACK).withSpecular(Rgb.BLACK).withTransmission(CLEAR.withIor(ior));
    }

    private static RenderOptions options(Engine engine, MirrorStorage storage) {
        return RenderOptions.DEFAULT.withThreads(1).withStorage(storage).withEngines(_ -> engine);
    }

    private static Scene edited(Scene scene, Random random) {
        Material material = scene.materials().get(random.nextInt(5));
        Transmission clear = material.transmission();
        return switch (random.nextInt(10)) {
            case 0 -> scene.withWorld(scene.world().withAmbience(random.nextDouble()));
            case 1 -> scene.withMaterial(material.withTransmission(clear.withTint(Rgb.gray(random.nextDouble()))));
            case 2 -> scene.withMaterial(material.withTransmission(clear.withTintDistance(random.nextDouble() + 0.1)));
            case 3 -> scene.withMaterial(material.withTransmission(clear.withIor(1 + random.nextDouble())));
            case 4 -> scene.withLight(scene.lights().getLast().withIntensity(random.nextDouble()));
            case 5 -> scene.withLight(scene.lights().getFirst().withPosition(new Vec3(random.nextDouble(), 3, 4)));
            default -> scene.withLight(scene.lights().getFirst().withIntensity(random.nextDouble()));
        };
    }

    @Property
    void editsInAnyOrder_equalReference(@ForAll Random random, @ForAll boolean scalar, @ForAll MirrorStorage storage) {
        Scene scene = scene();
        try (Renderer renderer = new Renderer(options(scalar ? Engines.SCALAR : Engines.LANES, storage))) {
            renderer.render(scene, Progress.NONE);
            for (int edit = 0; edit < 12; edit++) {
                scene = edited(scene, random);
                renderer.render(scene, Progress.NONE);
                FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), "edit " + edit);
            }
        }
    }

    @Test
    void samplesOfRepeatedEdits_equalReference() {
        Scene plain = scene();
        Scene scene = plain.withPicture(plain.picture().withSampling(new SamplingSettings(AntialiasMode.EDGES, 4)));
        try (Renderer renderer = new Renderer(options(Engines.LANES, MirrorStorage.FULL_ROWS))) {
            renderer.render(scene, Progress.NONE);
            for (double intensity : new double[] {0.72, 0.74, 0.76, 1.4, 0.1}) {
                Scene edited = scene.withLight(scene.lights().getFirst().withIntensity(intensity));
                renderer.render(edited, Progress.NONE);
                FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(edited).trace(), "intensity " + intensity);
            }
        }
    }
}
