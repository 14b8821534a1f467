package lightning.sample;

import java.util.List;
import lightning.scene.GatherSettings;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/**
 * Work that a random scene or session may cost in the usual check. The reference tracer tests each ray with each triangle, so few scenes
 * with blurred reflections or gathered light took most of the time of the properties. At night, nothing is limited.
 */
public final class TestBudget {
    /** Tries of a property from which nothing is limited. */
    private static final int NIGHTLY_TRIES = 50;
    private static final boolean IS_LIMITED = Integer.getInteger("jqwik.tries.default", NIGHTLY_TRIES) < NIGHTLY_TRIES;

    private static final int MAX_SIDE = 16;
    private static final int MAX_GRID = 3;
    private static final int MAX_LIGHT_SAMPLES = 5;
    private static final int REFLECTION_RAYS = 4;
    private static final int MAX_GATHER_RAYS = 16;
    private static final int MAX_BOUNCES = 2;
    private static final double SESSION_SECONDS = 2;

    private final long start = System.nanoTime();

    /** Returns the scene with a smaller picture and fewer samples if its points gather light or blur reflections. */
    static Scene limit(Scene scene) {
        return IS_LIMITED && GatherSettings.of(scene).isPresent() ? limited(scene) : scene;
    }

    /** Returns the scenes of a session, all of the same size, limited if any of them gathers light or blurs reflections. */
    static List<Scene> limit(List<Scene> session) {
        boolean isLimited = IS_LIMITED && session.stream().anyMatch(scene -> GatherSettings.of(scene).isPresent());
        return isLimited ? session.stream().map(TestBudget::limited).toList() : session;
    }

    private static Scene limited(Scene scene) {
        PictureSettings picture = scene.picture();
        SamplingSettings sampling = picture.sampling();
        List<Light> lights = scene.lights().stream()
                .map(light -> light.withArea(light.area().withSamples(Math.min(light.area().samples(), MAX_LIGHT_SAMPLES)))).toList();
        return scene.withLights(lights).withPicture(picture.withReflectionRays(Math.min(picture.reflectionRays(), REFLECTION_RAYS))
                .withSize(Math.min(picture.width(), MAX_SIDE), Math.min(picture.height(), MAX_SIDE))
                .withSampling(new SamplingSettings(sampling.antialias(), Math.min(sampling.grid(), MAX_GRID)))
                .withIndirect(picture.indirect().map(indirect -> new IndirectSettings(Math.min(indirect.bounces(), MAX_BOUNCES),
                        Math.min(indirect.rays(), MAX_GATHER_RAYS), indirect.spacing(), indirect.background()))));
    }

    /** Returns whether a session that started with this object has taken its time, so that its further edits are left out. */
    public boolean isSpent() {
        return IS_LIMITED && System.nanoTime() - start > SESSION_SECONDS * 1e9;
    }
}
