// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/archive.h>

#include <vector>

namespace Cautery
{
  /**
   * The best combination of earlier solutions as a first guess: Fischer, Comput. Methods Appl. Mech. Eng. 163
   * (1998) 193-204. Keeps an A-orthonormal basis of what earlier solves had to add to their guesses, together
   * with its images under A, so that a guess and its residual cost three products with tall dense matrices
   * (BLAS), one reduction over the processes, and no matrix. Once full, it keeps the span of the latest
   * solutions, where Fischer starts again from one: a restart costs a dozen solves from poor guesses.
   */
  class ProjectedGuess
  {
  public:
    explicit ProjectedGuess(const unsigned int capacity) : capacity(capacity) {}

    /** Forgets everything: the matrix is another one, of the norm (the largest row sum) given. */
    void clear(const double matrix_norm);

    /** Sets @p x to the guess for A x = b and turns @p residual, on entry b, into b - A x. */
    void apply(Vector &x, Vector &residual);

    /** Learns what had to be added to the last guess, @p correction, with @p image = A correction; uses both
     * up. */
    void learn(Vector &correction, Vector &image);

    /** The matrix is that of the archive already. On another number of processes all is forgotten. */
    void archive(Archive &archive);

  private:
    using Coefficients = std::vector<double>; ///< one for each direction

    Coefficients products(const Vector &x) const;
    bool         orthonormalise(Vector &direction, Vector &image, Coefficients &removed) const;
    void         condense();

    const unsigned int        capacity;
    double                    norm         = 0.; ///< of the matrix
    unsigned int              n_directions = 0;
    std::vector<double>       directions; ///< this process' rows, one direction after the other
    std::vector<double>       images;
    std::vector<Coefficients> solutions; ///< the latest, the last one last
  };
} // namespace Cautery
