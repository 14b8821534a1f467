package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.render.cache.PixelCache;
import lightning.render.image.Difference;
import lightning.render.image.Film;
import lightning.render.measure.AccuracyGuarantee;
import lightning.render.shading.RenderedScenes;
import lightning.render.shading.reference.ReferenceTracer;

/** Compares pictures with the reference. */
final class ReferenceCheck {
    private ReferenceCheck() {}

    /** Returns the reference picture of the scenes that a cache shows. */
    static Film referenceFilm(PixelCache cache) {
        return referenceTracer(cache.scenes()).trace();
    }

    /** Asserts the accuracy statement of a picture; returns its difference from the reference. */
    static Difference assertGuarantee(Renderer renderer, UpdateResult update, String when) {
        AccuracyGuarantee guarantee = AccuracyGuarantee.of(renderer, update);
        // A picture that is not reported as stale is compared with its own scene only.
        RenderedScenes compared = guarantee.isStale() ? guarantee.scenes() : RenderedScenes.of(guarantee.scenes().scene());
        Difference difference = Difference.of(renderer.film(), referenceTracer(compared).trace());
        assertThat(guarantee.isMetBy(difference))
                .as("%s: %s; stated %s, but %s values differ by up to %s", when, update.plan().description(), guarantee.text(update),
                        difference.values(), difference.maxAbsolute())
                .isTrue();
        return difference;
    }

    static ReferenceTracer referenceTracer(RenderedScenes scenes) {
        return new ReferenceTracer(scenes.scene(), scenes.mirrored());
    }
}
