package lightning.cli.report;

import org.jspecify.annotations.Nullable;

/**
 * A rendered image.
 *
 * @param method        {@code first pass}, {@code update} of the picture that a resident process kept, or {@code traditional trace}
 * @param cold          true if Java had not compiled its fast code yet
 * @param clippedPixels pixels above display white in a displayed format; absent for others
 * @param peakOverWhite largest value relative to display white; absent as above
 */
public record RenderReport(String image, String method, int widthPixels, int heightPixels, int depth, double milliseconds, boolean cold,
        RaysReport rays, @Nullable Long clippedPixels, @Nullable Double peakOverWhite) {}
