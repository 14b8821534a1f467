package lightning.base.process;

import lightning.base.text.Messages;

/**
 * Python package that the user installs for a converter.
 *
 * @param name  name for {@code pip install}
 * @param needs what needs it, in the plural, such as {@code USD files}; the key of a text
 */
public record PythonPackage(String name, String needs) {
    /** Returns what needs it, translated. */
    String title() {
        return Messages.tr(needs);
    }
}
