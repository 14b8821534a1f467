package lightning.relight;

import lightning.cache.PixelCache;
import lightning.image.Film;
import lightning.shading.ReferenceTracer;
import lightning.shading.Sight;

/** What a picture should be, by the reference. */
final class Oracle {
    private Oracle() {}

    /** The picture that a cache claims to show. */
    static Film of(PixelCache cache) {
        return reference(cache.sight()).trace();
    }

    static ReferenceTracer reference(Sight sight) {
        return new ReferenceTracer(sight.scene(), sight.mirrored());
    }
}
