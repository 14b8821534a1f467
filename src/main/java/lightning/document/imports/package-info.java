/** Choices for the import of a file, each with a traced picture: {@link lightning.document.imports.ImportPreviews}. */
@NullMarked
package lightning.document.imports;

import org.jspecify.annotations.NullMarked;
