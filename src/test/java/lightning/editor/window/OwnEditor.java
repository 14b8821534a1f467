package lightning.editor.window;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.TestInfo;

/**
 * Gives a test, or each test of a class, an editor of its own: for tests of starting, closing and preferences, and of panels that keep
 * their state when another document opens.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
public @interface OwnEditor {
    /** Finds the annotation. */
    final class Uses {
        private Uses() {}

        static boolean isUsedBy(TestInfo test) {
            return test.getTestClass().orElseThrow().isAnnotationPresent(OwnEditor.class)
                    || test.getTestMethod().orElseThrow().isAnnotationPresent(OwnEditor.class);
        }
    }
}
