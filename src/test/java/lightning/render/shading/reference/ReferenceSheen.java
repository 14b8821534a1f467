package lightning.render.shading.reference;

import lightning.render.lobe.SheenLobe;
import lightning.render.trace.MappedSurface;
import lightning.scene.material.Material;

/** Sheen of materials for {@link ReferenceTracer}. */
final class ReferenceSheen {
    private ReferenceSheen() {}

    /** Returns one channel of the share that a surfel with a sheen sends back. @param below share without it */
    static float albedo(Material material, MappedSurface at, int c, float below) {
        if (!material.hasSheen()) {
            return below;
        }
        float mean = SheenLobe.meanAlbedo(at.sheenRoughness());
        float max = Math.max(at.sheen(0), Math.max(at.sheen(1), at.sheen(2)));
        return below * (1 - max * mean) + at.sheen(c) * mean;
    }
}
