package lightning.document;

import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.value.SceneLimits;

/** Area in which an image is shown, in physical pixels of the screen. */
public record PictureArea(double width, double height) {
    /** Area for new scenes while no pane shows an image. */
    public static final PictureArea DEFAULT = new PictureArea(1280, 720);

    /** Sides of a usable area, pixels. A hidden pane is smaller. */
    private static final double MIN_SIDE = 64;

    /** Returns an area; the default one for a pane that is hidden or too small. */
    public static PictureArea of(double width, double height) {
        return width >= MIN_SIDE && height >= MIN_SIDE ? new PictureArea(width, height) : DEFAULT;
    }

    /** Returns the settings with the largest size of the same aspect ratio that fits, and with smooth edges. */
    public PictureSettings fit(PictureSettings picture) {
        PictureSettings fitted = size(picture);
        return picture.sampling().isSupersampled() ? fitted
                : fitted.withSampling(new SamplingSettings(AntialiasMode.EDGES, picture.sampling().grid()));
    }

    /** Returns the settings with the largest size of the same aspect ratio that fits. */
    public PictureSettings size(PictureSettings picture) {
        double scale = Math.min(width / picture.width(), height / picture.height());
        return picture.withSize(side(picture.width() * scale), side(picture.height() * scale));
    }

    /** Returns the middle part with a share of both sides. @param share above 0, at most 1 */
    public PictureArea part(double share) {
        return new PictureArea(width * share, height * share);
    }

    private static int side(double pixels) {
        // The tolerance keeps a side that fits exactly.
        return (int) Math.clamp(Math.floor(pixels + 1e-6), 1, SceneLimits.MAX_SIZE);
    }
}
