package lightning.cli.report;

import org.jspecify.annotations.Nullable;

/**
 * Difference of two images.
 *
 * @param values                    three for each pixel
 * @param maxDifferenceLinear       largest absolute difference
 * @param maxDifferenceUlp          the same in units in the last place; absent unless both files hold 32-bit floats
 * @param maxDifferenceLevels       the same as displayed, in levels of 255
 * @param maxDifferenceX            column of the pixel with the largest difference; absent if the images are equal
 * @param maxDifferenceY            its row from the top; absent if the images are equal
 * @param psnrDb                    of linear values; null if the images are equal
 * @param displayedPsnrDb           of 8-bit values; null if they are equal
 */
public record CompareReport(boolean equal, int widthPixels, int heightPixels, long pixels, long differentPixels, long values,
        long differentValues, double maxDifferenceLinear, @Nullable Long maxDifferenceUlp, int maxDifferenceLevels,
        @Nullable Integer maxDifferenceX,
        @Nullable Integer maxDifferenceY, double meanDifferenceLinear, double rmseLinear, double psnrDb, double displayedPsnrDb,
        double ssim, double flip) {}
