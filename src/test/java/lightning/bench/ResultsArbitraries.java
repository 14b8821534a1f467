package lightning.bench;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Results with anything in them, made from the records themselves: no field can be forgotten. */
final class ResultsArbitraries {
    private static final double[] DOUBLES = {0, -0.0, 1.5, -3, 1e-300, 0.1, Double.NaN, Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY, Double.MAX_VALUE, Double.MIN_VALUE};
    private static final String[] STRINGS = {"", "plain", "with, comma", "with \"quotes\"", "two\nlines", "ä → ꟻ ≥ 0", "NaN", "null"};
    /** What may be missing, by the records' own words. */
    private static final List<Class<?>> NULLABLE =
            List.of(FirstPassResult.class, PeerResult.class, ColdStart.class, ColdStart.Rival.class, MeshPoint.Rival.class,
                    UpdateWork.class);
    private static final List<String> NULLABLE_NAMES = List.of("before", "picture", "difference", "processor", "rival");

    private final Random random;

    private ResultsArbitraries(long seed) {
        random = new Random(seed);
    }

    static BenchResults of(long seed) {
        return (BenchResults) new ResultsArbitraries(seed).value(BenchResults.class, "");
    }

    private Object value(Type type, String name) {
        if (type instanceof ParameterizedType list) {
            List<Object> items = new ArrayList<>();
            for (int i = random.nextInt(3); i > 0; i--) {
                items.add(value(list.getActualTypeArguments()[0], "item"));
            }
            return items;
        }
        Class<?> raw = (Class<?>) type;
        if ((NULLABLE.contains(raw) || NULLABLE_NAMES.contains(name)) && random.nextInt(4) == 0) {
            return null;
        }
        if (raw.isEnum()) {
            return raw.getEnumConstants()[random.nextInt(raw.getEnumConstants().length)];
        }
        if (raw.isRecord()) {
            return record(raw);
        }
        return switch (raw.getSimpleName()) {
            case "int" -> random.nextInt();
            case "long" -> random.nextLong();
            case "boolean" -> random.nextBoolean();
            case "double", "Double" -> random.nextBoolean() ? random.nextGaussian() : DOUBLES[random.nextInt(DOUBLES.length)];
            case "String" -> STRINGS[random.nextInt(STRINGS.length)];
            default -> throw new AssertionError("no values of " + raw);
        };
    }

    private Object record(Class<?> type) {
        RecordComponent[] components = type.getRecordComponents();
        Class<?>[] types = new Class<?>[components.length];
        Object[] values = new Object[components.length];
        for (int i = 0; i < components.length; i++) {
            types[i] = components[i].getType();
            values[i] = value(components[i].getGenericType(), components[i].getName());
        }
        try {
            var constructor = type.getDeclaredConstructor(types);
            constructor.setAccessible(true);
            return constructor.newInstance(values);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(type.getName(), e);
        }
    }
}
