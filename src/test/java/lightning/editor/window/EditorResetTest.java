package lightning.editor.window;

import static lightning.editor.window.TestEditors.inWindowThread;
import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayDeque;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Queue;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import javafx.beans.property.Property;
import javafx.beans.value.ObservableValue;
import lightning.document.OpenDocument;
import lightning.editor.window.model.FileActivity;
import org.junit.jupiter.api.Test;
import org.testfx.api.FxToolkit;

/** Tests that nothing of a test remains in the editor that the next test uses. */
class EditorResetTest extends EditorFixture {
    /** Object of the model that is still to be searched. */
    private record Place(String path, Object value) {}

    /** Returns all properties with simple values that the model's objects have, by their paths of fields. */
    private Map<String, ObservableValue<?>> properties() throws IllegalAccessException {
        Map<String, ObservableValue<?>> found = new TreeMap<>();
        Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());
        Queue<Place> queue = new ArrayDeque<>();
        queue.add(new Place("model", model()));
        while (!queue.isEmpty()) {
            Place place = queue.remove();
            if (!seen.add(place.value())) {
                continue;
            }
            if (place.value() instanceof FileActivity) {
                continue; // It lasts as long as a file is read or written.
            }
            if (place.value() instanceof ObservableValue<?> property) {
                found.put(place.path(), property);
                continue;
            }
            for (Class<?> type = place.value().getClass(); type != null && isOfEditor(type); type = type.getSuperclass()) {
                for (Field field : type.getDeclaredFields()) {
                    if (!Modifier.isStatic(field.getModifiers()) && !field.getType().isPrimitive()) {
                        field.setAccessible(true);
                        Object value = field.get(place.value());
                        if (value instanceof ObservableValue<?> || value != null && isOfEditor(value.getClass())) {
                            queue.add(new Place(place.path() + "." + field.getName(), value));
                        }
                    }
                }
            }
        }
        return found;
    }

    private static boolean isOfEditor(Class<?> type) {
        return type.getName().startsWith("lightning.editor.") && !type.isRecord() && !type.isEnum();
    }

    /** Returns the texts of all values that are settings: decisions, decimal numbers, texts, and constants of enums. Whole numbers count changes. */
    private static Map<String, String> values(Map<String, ObservableValue<?>> properties) {
        return properties.entrySet().stream().filter(e -> isSimple(e.getValue().getValue()))
                .collect(Collectors.toMap(Map.Entry::getKey, e -> String.valueOf(e.getValue().getValue()), (a, _) -> a, TreeMap::new));
    }

    private static boolean isSimple(Object value) {
        return value instanceof Boolean || value instanceof Double || value instanceof String || value instanceof Enum<?>;
    }

    private static Object other(Object value) {
        return switch (value) {
            case Boolean flag -> !flag;
            case Double number -> number + 1;
            case String text -> text + "x";
            case Enum<?> constant -> {
                Object[] all = constant.getDeclaringClass().getEnumConstants();
                yield all[(constant.ordinal() + 1) % all.length];
            }
            default -> value;
        };
    }

    /** Changes a property if it accepts another value; returns whether it did. */
    @SuppressWarnings("unchecked")
    private static boolean change(ObservableValue<?> value) {
        if (!(value instanceof Property<?> property) || property.isBound() || !isSimple(property.getValue())) {
            return false;
        }
        Object before = property.getValue();
        try {
            ((Property<Object>) property).setValue(other(before));
        } catch (IllegalArgumentException e) {
            return false;
        }
        return !Objects.equals(before, property.getValue());
    }

    @Test
    void reset_restoresEverySetting() throws Exception {
        EditorReset reset = inWindowThread(() -> EditorReset.of(stage, editor));
        Map<String, ObservableValue<?>> properties = inWindowThread(this::properties);
        Map<String, String> before = inWindowThread(() -> values(properties));
        long changed = inWindowThread(() -> properties.values().stream().filter(EditorResetTest::change).count());
        assertThat(changed).as("settings that the test changes: " + before.keySet()).isGreaterThan(15);
        assertThat(inWindowThread(() -> values(properties))).isNotEqualTo(before);
        OpenDocument document = TestEditors.document(model().workbench().document().file());
        FxToolkit.setupFixture(() -> reset.restore(document));
        waitForPicture();
        assertThat(inWindowThread(() -> values(properties))).isEqualTo(before);
    }
}
