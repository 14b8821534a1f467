package lightning.cli.option;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.text.Quote;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Rectangle of pixels, written {@code X,Y,WIDTH,HEIGHT} on the command line; X and Y from 0 at the upper left, WIDTH and HEIGHT from 1. */
public record PixelRegion(int x, int y, int width, int height) {
    private static final Pattern PATTERN = Pattern.compile("(\\d{1,9}),(\\d{1,9}),(\\d{1,9}),(\\d{1,9})");

    public static final class Converter implements ITypeConverter<PixelRegion> {
        @Override
        public PixelRegion convert(String text) {
            Matcher form = PATTERN.matcher(text);
            if (!form.matches() || Integer.parseInt(form.group(3)) == 0 || Integer.parseInt(form.group(4)) == 0) {
                throw new TypeConversionException("expected X,Y,WIDTH,HEIGHT such as 100,50,320,240, found " + Quote.of(text));
            }
            return new PixelRegion(Integer.parseInt(form.group(1)), Integer.parseInt(form.group(2)), Integer.parseInt(form.group(3)),
                    Integer.parseInt(form.group(4)));
        }
    }
}
