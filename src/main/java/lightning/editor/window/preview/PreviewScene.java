package lightning.editor.window.preview;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Material;
import lightning.scene.Panorama;
import lightning.scene.Scene;
import lightning.scene.SkyLamp;
import lightning.scene.Stage;
import lightning.scene.World;

/**
 * The scene as the preview traces it, which has neither mirrors nor shadows: what would be black without the one has a colour, and what
 * would burn out without the other is dimmed.
 */
final class PreviewScene {
    /** How much of a metal stays one: all else scatters its colour, in place of what it would mirror. */
    private static final double METAL = 0.4;
    /** Which part of what a mirror would show it scatters. */
    private static final double MIRRORED = 0.5;

    /** What white paper in an environment stays below, about. */
    private static final double PAPER = 0.9;

    private Stage stage;
    private Stage shown;
    private List<SkyLamp> lamps = List.of();
    /** What white paper shines with under these, where it is turned to the most light. */
    private double brightest;

    Scene of(Scene scene) {
        if (scene.stage() != stage) {
            stage = scene.stage();
            // A list that is equal leaves the stage as it is, and with it all that is known of it.
            shown = stage.withMaterials(stage.materials().stream().map(PreviewScene::scattering).toList());
        }
        World world = scene.world();
        return scene.withStage(shown).withWorld(world.environment().map(e -> dimmed(world, e)).orElse(world));
    }

    static Material scattering(Material material) {
        return material.isMetallic() ? material.withMetalness(METAL * material.metalness())
                : material.reflective().isBlack() ? material
                : material.withDiffuse(sum(material.diffuse(), material.reflective()));
    }

    private static Rgb sum(Rgb diffuse, Rgb reflective) {
        return new Rgb(Math.min(1, diffuse.r() + MIRRORED * reflective.r()), Math.min(1, diffuse.g() + MIRRORED * reflective.g()),
                Math.min(1, diffuse.b() + MIRRORED * reflective.b()));
    }

    /**
     * A world whose environment leaves white paper below 1. Nothing shades its lamps here: what lets a little of them through a window
     * would be lit by all.
     */
    private World dimmed(World world, Panorama environment) {
        List<SkyLamp> now = environment.sky().lamps(world.lamps());
        if (now != lamps) {
            lamps = now;
            brightest = now.stream().mapToDouble(lamp -> brightness(lamp.towards(), now)).max().orElse(0);
        }
        double all = brightest * world.intensity() / PAPER;
        return all > 0 ? world.withIntensity(-Math.expm1(-all) * PAPER / brightest) : world;
    }

    private static double brightness(Vec3 normal, List<SkyLamp> lamps) {
        return lamps.stream().mapToDouble(lamp -> Math.max(0, normal.dot(lamp.towards()))
                * new Rgb(lamp.red(), lamp.green(), lamp.blue()).luminance()).sum();
    }
}
