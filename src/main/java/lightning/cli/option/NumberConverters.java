package lightning.cli.option;

import java.math.BigDecimal;
import java.util.function.Function;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/**
 * Parses numbers of the command line as in scene files; picocli's own parser also accepts {@code 0x10}, {@code 010} and
 * {@code 1d}.
 */
public final class NumberConverters {
    private NumberConverters() {}

    /** Registers the converters with all commands, including subcommands already added. */
    public static void register(CommandLine commands) {
        ITypeConverter<Integer> intConverter = text -> parseInteger(text, BigDecimal::intValueExact);
        ITypeConverter<Long> longConverter = text -> parseInteger(text, BigDecimal::longValueExact);
        commands.registerConverter(int.class, intConverter).registerConverter(Integer.class, intConverter);
        commands.registerConverter(long.class, longConverter).registerConverter(Long.class, longConverter);
        commands.registerConverter(double.class, NumberConverters::parseNumber).registerConverter(Double.class,
                NumberConverters::parseNumber);
    }

    private static <T> T parseInteger(String text, Function<BigDecimal, T> conversion) {
        if (DecimalNumber.parse(text).isPresent()) {
            try {
                return conversion.apply(new BigDecimal(text));
            } catch (ArithmeticException | NumberFormatException e) {
                // A fraction and an overflow give the same message.
            }
        }
        throw new TypeConversionException("expected a whole number, found " + Quote.of(text));
    }

    private static double parseNumber(String text) {
        return DecimalNumber.parse(text).orElseThrow(() -> new TypeConversionException("expected a number, found " + Quote.of(text)));
    }
}
