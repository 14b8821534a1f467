package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.bench.accuracy.Promise;
import lightning.render.cache.PixelCache;
import lightning.render.image.Difference;
import lightning.render.image.Film;
import lightning.render.shading.ReferenceTracer;
import lightning.render.shading.SeenScenes;

/** What a picture should be, by the reference. */
final class Oracle {
    private Oracle() {}

    /** The picture that a cache claims to show. */
    static Film of(PixelCache cache) {
        return reference(cache.scenes()).trace();
    }

    /** Requires that a picture is what it is said to be; returns how far it is from the reference. */
    static Difference assertKept(Renderer renderer, Update update, String when) {
        Promise promise = Promise.of(renderer, update);
        // A picture that is not called stale is held against its own scene alone.
        SeenScenes said = promise.isStale() ? promise.scenes() : SeenScenes.of(promise.scenes().scene());
        Difference difference = Difference.of(renderer.film(), reference(said).trace());
        assertThat(promise.isKeptBy(difference))
                .as("%s: %s; %s was promised, %s is off by %s", when, update.plan().text(), promise.text(update),
                        difference.values(), difference.maxAbsolute())
                .isTrue();
        return difference;
    }

    static ReferenceTracer reference(SeenScenes scenes) {
        return new ReferenceTracer(scenes.scene(), scenes.mirrored());
    }
}
