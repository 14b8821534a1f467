package lightning.cli.output;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import lightning.base.file.FileErrorMessage;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.base.work.Progress;
import lightning.format.image.CubeLutReader;
import lightning.format.ocio.OcioReference;
import lightning.format.ocio.OcioView;
import lightning.render.image.CubeLut;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Log2Shaper;
import lightning.render.image.ViewTransform;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/**
 * Parser of view transforms: a curve, a .cube file, or both with a plus sign. A logarithm instead of the curve needs a file: {@code
 * log2:-10,6.5+look.cube}. Or a view of OpenColorIO: {@code ocio:DISPLAY/VIEW}.
 */
final class ViewConverter implements ITypeConverter<ViewChoice> {
    @Override
    public ViewChoice convert(String text) {
        List<String> notes = new ArrayList<>();
        return OcioReference.isReference(text) ? ocio(text) : new ViewChoice(transform(text, notes::add), notes);
    }

    private static ViewChoice ocio(String text) {
        try {
            OcioView view = OcioView.bake(OcioReference.parse(text, System.getenv(OcioReference.VARIABLE)), Progress.NONE);
            List<String> notes = new ArrayList<>(List.of(view.title() + ": " + view.errorText()));
            if (!view.facts().note().isEmpty()) {
                notes.add(view.title() + ": " + view.facts().note());
            }
            return new ViewChoice(view.transform(), notes);
        } catch (IOException e) {
            throw new TypeConversionException(FileErrorMessage.of(e));
        }
    }

    private static ViewTransform transform(String text, Consumer<String> notes) {
        int plus = text.indexOf('+');
        String word = plus < 0 ? text : text.substring(0, plus);
        Optional<DisplayCurve> curve = Arrays.stream(DisplayCurve.values()).filter(c -> c.word().equals(word)).findFirst();
        boolean isLog = word.equals(Log2Shaper.WORD) || word.startsWith(Log2Shaper.WORD + ":");
        ViewTransform view = ViewTransform.DEFAULT.withCurve(curve.orElse(DisplayCurve.SRGB));
        if (!isLog && curve.isEmpty()) {
            return view.withLut(Optional.of(table(text, notes)));
        }
        if (isLog) {
            view = view.withShaper(Optional.of(shaper(word)));
            if (plus < 0) {
                throw new TypeConversionException("expected a .cube file after " + word + ", such as " + word + "+look.cube");
            }
        }
        if (plus < 0) {
            return view;
        }
        CubeLut table = table(text.substring(plus + 1), notes);
        if (table.log().isPresent()) {
            throw new TypeConversionException(Quote.path(table.file()) + " is made for " + table.log().get().text()
                    + " and replaces the transform; use it without " + word + "+");
        }
        return view.withLut(Optional.of(table));
    }

    private static Log2Shaper shaper(String word) {
        if (word.equals(Log2Shaper.WORD)) {
            return Log2Shaper.DEFAULT;
        }
        try {
            return Log2Shaper.parse(word);
        } catch (RefusalException e) {
            throw new TypeConversionException(e.getMessage());
        }
    }

    private static CubeLut table(String file, Consumer<String> notes) {
        if (!file.endsWith(CubeLutReader.EXTENSION)) {
            throw new TypeConversionException(
                    "expected srgb, 1998, filmic, aces, aces2, agx, false, ocio:DISPLAY/VIEW or a .cube file, found " + Quote.of(file));
        }
        try {
            return CubeLutReader.read(Path.of(file), notes);
        } catch (InvalidPathException | IOException e) {
            throw new TypeConversionException("expected a .cube LUT: " + e.getMessage());
        }
    }
}
