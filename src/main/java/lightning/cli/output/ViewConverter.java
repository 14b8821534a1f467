package lightning.cli.output;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;
import lightning.format.image.CubeLutReader;
import lightning.render.image.CubeLut;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Log2Shaper;
import lightning.render.image.ViewTransform;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/**
 * Parser of view transforms: a curve, a .cube file, or both with a plus sign. A logarithm instead of the curve needs a file: {@code
 * log2:-10,6.5+look.cube}.
 */
public final class ViewConverter implements ITypeConverter<ViewTransform> {
    @Override
    public ViewTransform convert(String text) {
        int plus = text.indexOf('+');
        String word = plus < 0 ? text : text.substring(0, plus);
        Optional<DisplayCurve> curve = Arrays.stream(DisplayCurve.values()).filter(c -> c.word().equals(word)).findFirst();
        boolean isLog = word.equals(Log2Shaper.WORD) || word.startsWith(Log2Shaper.WORD + ":");
        ViewTransform view = ViewTransform.DEFAULT.withCurve(curve.orElse(DisplayCurve.SRGB));
        if (!isLog && curve.isEmpty()) {
            return view.withLut(Optional.of(table(text)));
        }
        if (isLog) {
            view = view.withShaper(Optional.of(shaper(word)));
            if (plus < 0) {
                throw new TypeConversionException("expected a .cube file after " + word + ", such as " + word + "+look.cube");
            }
        }
        return plus < 0 ? view : view.withLut(Optional.of(table(text.substring(plus + 1))));
    }

    private static Log2Shaper shaper(String word) {
        if (word.equals(Log2Shaper.WORD)) {
            return Log2Shaper.DEFAULT;
        }
        double[] stops = Arrays.stream(word.substring(Log2Shaper.WORD.length() + 1).split(",", -1))
                .mapToDouble(v -> DecimalNumber.parse(v).orElse(Double.NaN)).toArray();
        if (stops.length != 2) {
            throw new TypeConversionException("expected two numbers of stops such as log2:-6.5,6.5, found " + Quote.of(word));
        }
        try {
            return new Log2Shaper(stops[0], stops[1]);
        } catch (IllegalArgumentException e) {
            throw new TypeConversionException(e.getMessage());
        }
    }

    private static CubeLut table(String file) {
        if (!file.endsWith(CubeLutReader.EXTENSION)) {
            throw new TypeConversionException(
                    "expected srgb, 1998, filmic, aces, aces2, agx, false or a .cube file, found " + Quote.of(file));
        }
        try {
            return CubeLutReader.read(Path.of(file));
        } catch (InvalidPathException | IOException e) {
            throw new TypeConversionException("expected a .cube LUT: " + e.getMessage());
        }
    }
}
