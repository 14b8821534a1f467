package lightning.cli;

import java.util.concurrent.Callable;
import lightning.cache.PixelCache;
import lightning.effects.Effect;
import lightning.effects.Effects;
import lightning.relight.Options;
import lightning.relight.Renderer;
import lightning.relight.Update;
import lightning.scene.Scene;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** Tells which effects a scene calls for and what they take. */
@Command(name = "effects", header = "Tell what a scene calls for, with time and bytes.", abbreviateSynopsis = true,
        description = {
            "Derives from the scene alone which effects its picture needs, and names the lights, materials and shapes that call",
            "for each. Then traces the picture once and tells how many bytes each kind of column takes, and how many bytes the",
            "effects that are absent would take besides (estimated from the rows there are)."},
        footer = {
            "Example:",
            "  lightning effects scenes/bird.jen --size 1920x1080"})
final class EffectsCommand implements Callable<Integer> {
    private final Console console;

    @Mixin
    private SceneFile input;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;

    EffectsCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        Scene scene = picture.apply(input.read().scene());
        Effects effects = Effects.of(scene);
        for (Effect effect : Effect.values()) {
            console.line("%-20s %s", effect.title(), effects.has(effect) ? effects.why(effect) : "-");
        }
        try (Renderer renderer = new Renderer(Options.DEFAULT.withThreads(threads.count()));
                ProgressBar bar = new ProgressBar(console, "tracing")) {
            Update update = renderer.render(scene, bar);
            print(effects, renderer.cache(), update);
        }
        return ExitCode.DONE;
    }

    private void print(Effects effects, PixelCache cache, Update update) {
        var bytes = ColumnBytes.of(cache);
        console.line("");
        console.line("first pass: %.1f ms, %d rows; %d eye rays, %d mirrored, %d shadow rays", update.milliseconds(), bytes.rows(),
                update.rays().eye(), update.rays().mirrored(), update.rays().shadow());
        column("point, normal, view, place", bytes.geometry(), bytes);
        column("texture colours", bytes.textures(), bytes);
        column("mirror images", bytes.mirrored(), bytes);
        column("states of the lights", bytes.states(), bytes);
        column("cosines", bytes.cosines(), bytes);
        column("specular terms", bytes.speculars(), bytes);
        column("falloffs", bytes.falloffs(), bytes);
        column("in all", bytes.all(), bytes);
        absent(effects, bytes);
    }

    private void column(String title, long bytes, ColumnBytes all) {
        console.line("  %-28s %12d bytes %8.2f a row", title, bytes, (double) bytes / Math.max(all.rows(), 1));
    }

    private void absent(Effects effects, ColumnBytes bytes) {
        long layers = bytes.layerRows();
        if (!effects.has(Effect.TEXTURES)) {
            saved("textures", ColumnBytes.COLOR * bytes.rows());
        }
        if (!effects.has(Effect.SPECULAR)) {
            saved("specular highlights", ColumnBytes.TERM * layers);
        }
        if (!effects.has(Effect.ATTENUATION) && !effects.has(Effect.DROPOFF)) {
            saved("attenuation and dropoff", ColumnBytes.TERM * layers);
        }
        if (!effects.has(Effect.REFLECTION)) {
            saved("reflection (a mirror bounce)", ColumnBytes.COLOR * bytes.rows() + bytes.all());
        }
    }

    private void saved(String effect, long bytes) {
        console.line("  %-28s %12d bytes saved at most, because it is absent", effect, bytes);
    }
}
