package lightning.render.measure;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/** Setting of an effect that {@link SettingSweep} compares with others. */
public sealed interface SweptSetting {
    /** Returns a scene with this setting. */
    Scene applyTo(Scene scene);

    /** Returns the expected work relative to other settings of the effect, &gt; 0. */
    double expectedWork();

    /**
     * Setting of indirect light.
     *
     * @param spacing distance of gather points, pixels
     * @param rays    rays of a gather point
     */
    record Gathering(int spacing, int rays) implements SweptSetting {
        private static final int[] SPACINGS = {16, 8, 4};
        private static final int[] RAYS = {16, 64, 256};

        /** Returns all settings, from fast to slow for each spacing. */
        static List<SweptSetting> all() {
            return Arrays.stream(SPACINGS).boxed()
                    .flatMap(spacing -> Arrays.stream(RAYS).<SweptSetting>mapToObj(rays -> new Gathering(spacing, rays))).toList();
        }

        @Override
        public Scene applyTo(Scene scene) {
            IndirectSettings before = scene.picture().indirect().orElse(IndirectSettings.DEFAULT);
            return scene.withPicture(scene.picture().withIndirect(Optional.of(before.withSpacing(spacing).withRays(rays))));
        }

        /** The rays of the gather points, and a part that does not depend on them. */
        @Override
        public double expectedWork() {
            return (rays + 64.0) / (spacing * spacing);
        }
    }

    /**
     * Setting of blurred reflections.
     *
     * @param rays rays of each point
     */
    record ReflectionRays(int rays) implements SweptSetting {
        /** Returns all settings, from fast to slow. */
        static List<SweptSetting> all() {
            return PictureSettings.REFLECTION_RAY_COUNTS.stream().<SweptSetting>map(ReflectionRays::new).toList();
        }

        @Override
        public Scene applyTo(Scene scene) {
            return scene.withPicture(scene.picture().withReflectionRays(rays));
        }

        /** The rays of the points, and a part that does not depend on them. */
        @Override
        public double expectedWork() {
            return rays + 16.0;
        }
    }

    /**
     * Setting of soft shadows.
     *
     * @param samples samples of each area light
     */
    record LightSamples(int samples) implements SweptSetting {
        private static final int[] SAMPLES = {4, 8, 16, 32, 64};

        /** Returns all settings, from fast to slow. */
        static List<SweptSetting> all() {
            return IntStream.of(SAMPLES).<SweptSetting>mapToObj(LightSamples::new).toList();
        }

        @Override
        public Scene applyTo(Scene scene) {
            return scene.withLights(scene.lights().stream().map(this::withSamples).toList());
        }

        private Light withSamples(Light light) {
            return light.hasSamples() ? light.withArea(light.area().withSamples(samples)) : light;
        }

        @Override
        public double expectedWork() {
            return samples;
        }
    }
}
