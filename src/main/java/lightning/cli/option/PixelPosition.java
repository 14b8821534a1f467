package lightning.cli.option;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.text.Quote;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Pixel coordinates, written {@code 150,230} on the command line; both from 0, x to the right, y down. */
public record PixelPosition(int x, int y) {
    private static final Pattern PATTERN = Pattern.compile("(\\d{1,9}),(\\d{1,9})");

    public static final class Converter implements ITypeConverter<PixelPosition> {
        @Override
        public PixelPosition convert(String text) {
            Matcher form = PATTERN.matcher(text);
            if (!form.matches()) {
                throw new TypeConversionException("expected X,Y such as 150,230, found " + Quote.of(text));
            }
            return new PixelPosition(Integer.parseInt(form.group(1)), Integer.parseInt(form.group(2)));
        }
    }
}
