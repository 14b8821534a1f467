package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.bench.accuracy.AccuracyGuarantee;
import lightning.render.cache.PixelCache;
import lightning.render.image.Difference;
import lightning.render.image.Film;
import lightning.render.shading.ReferenceTracer;
import lightning.render.shading.RenderedScenes;

/** What a picture should be, by the reference. */
final class ReferenceCheck {
    private ReferenceCheck() {}

    /** The picture that a cache claims to show. */
    static Film referenceFilm(PixelCache cache) {
        return referenceTracer(cache.scenes()).trace();
    }

    /** Requires that a picture is what it is said to be; returns how far it is from the reference. */
    static Difference assertPromise(Renderer renderer, UpdateResult update, String when) {
        AccuracyGuarantee promise = AccuracyGuarantee.of(renderer, update);
        // A picture that is not called stale is held against its own scene alone.
        RenderedScenes compared = promise.isStale() ? promise.scenes() : RenderedScenes.of(promise.scenes().scene());
        Difference difference = Difference.of(renderer.film(), referenceTracer(compared).trace());
        assertThat(promise.isMetBy(difference))
                .as("%s: %s; %s was promised, %s is off by %s", when, update.plan().description(), promise.text(update),
                        difference.values(), difference.maxAbsolute())
                .isTrue();
        return difference;
    }

    static ReferenceTracer referenceTracer(RenderedScenes scenes) {
        return new ReferenceTracer(scenes.scene(), scenes.mirrored());
    }
}
