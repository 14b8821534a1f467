package lightning.render.gather.ray;

import java.util.Locale;
import lightning.base.text.UserFacingException;
import lightning.scene.GatherSettings;

/** Reports that the paths of indirect light do not fit into memory. */
public final class PathsTooLargeException extends RuntimeException implements UserFacingException {
    private static final long serialVersionUID = 1;

    private final long requiredBytes;

    /**
     * @param required  bytes that were needed before the paths were complete
     * @param available bytes
     */
    PathsTooLargeException(GatherSettings settings, long required, long available) {
        super(String.format(Locale.ROOT,
                "%s needs more than %.1f GB of memory, and %.1f GB is available; "
                        + "use fewer rays, fewer bounces or more pixels between gather points",
                settings.label(), required / 1e9, available / 1e9));
        requiredBytes = required;
    }

    /** Returns the bytes that were needed before the paths were complete. */
    public long requiredBytes() {
        return requiredBytes;
    }
}
