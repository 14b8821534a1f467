package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.bench.result.SoftShadowAccuracy;
import lightning.bench.result.TimeSamples;
import lightning.render.RenderOptions;
import lightning.render.measure.SoftShadowErrorMeter;
import lightning.render.measure.SweptEffect;
import lightning.render.measure.SweptSetting;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/** Benchmark of area lights: time against error on scenes that have some, and on a generated room whose lights are balls. */
record SoftShadowBench(BenchSettings settings, ResultCollector ledger) {
    private static final PictureSize SIZE = new PictureSize(960, 540);
    private static final PictureSize QUICK_SIZE = new PictureSize(48, 27);
    /** Predicted milliseconds of a scene. */
    private static final double MS = 40_000;
    private static final double QUICK_MS = 2000;
    /** Radius of the room's lights, scene units. */
    private static final double RADIUS = 0.15;

    /** Returns the parts to measure for these scenes and a generated room. */
    List<BenchPart> parts(List<NamedScene> scenes) {
        Scene room = IndirectBench.room(settings);
        List<NamedScene> all = new ArrayList<>(scenes);
        all.add(new NamedScene(IndirectBench.ROOM, room.withLights(room.lights().stream()
                .map(light -> light.withArea(light.area().withRadius(RADIUS))).toList()), null));
        return all.stream().filter(scene -> SweptEffect.SOFT_SHADOWS.missingReason(scene.scene()).isEmpty())
                .map(scene -> new BenchPart(scene.name() + ", time against error of area lights", settings.quick() ? QUICK_MS : MS,
                        progress -> ledger.indirect().add(measure(scene, progress))))
                .toList();
    }

    private SoftShadowAccuracy measure(NamedScene named, Progress progress) {
        PictureSize size = settings.quick() ? QUICK_SIZE : SIZE;
        Scene scene = size.of(named.scene());
        Progress silent = progress.cancellationOnly();
        List<SweptSetting> measured = SweptEffect.SOFT_SHADOWS.settings();
        try (var meter = new SoftShadowErrorMeter(scene, RenderOptions.DEFAULT.withThreads(settings.threads()), silent)) {
            List<SoftShadowAccuracy.Point> points = new ArrayList<>();
            for (SweptSetting setting : measured) {
                int samples = ((SweptSetting.LightSamples) setting).samples();
                SoftShadowErrorMeter.Measured result = meter.measure(samples, settings.repetitions(), silent);
                points.add(new SoftShadowAccuracy.Point(samples, TimeSamples.of(result.time()), result.mean(), result.high()));
                progress.report(points.size(), measured.size());
            }
            return new SoftShadowAccuracy(named.name(), size.width(), size.height(),
                    (int) scene.lights().stream().filter(Light::isArea).count(), points);
        }
    }
}
