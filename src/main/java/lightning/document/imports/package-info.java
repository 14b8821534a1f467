/** What the import of a file offers, with a traced picture of each choice: {@link lightning.document.imports.ImportPreviews}. */
@NullMarked
package lightning.document.imports;

import org.jspecify.annotations.NullMarked;
